#include "tidy_recording.hpp"

#include "core/files.hpp"

namespace amiss::app {

namespace {

namespace fs = std::filesystem;

/// The reference as its files, which a replay reads as any other; parameters and world as they were used.
std::map<std::string, std::string> documents(const report::RunFolder& folder, const TidyRecording::Wanted& wanted) {
  const fs::path reference = folder.path() / "reference";
  fs::create_directories(reference);
  mission::save_reference(reference, wanted.reference);
  std::map<std::string, std::string> documents;
  for (const auto& entry : fs::directory_iterator(reference)) {
    documents[entry.path().filename().string()] = load_bytes(entry.path());
  }
  fs::remove_all(reference);
  documents["params.yaml"] = load_bytes(folder.path() / "params.yaml");
  documents["world.sdf"] = load_bytes(wanted.world.file);
  return documents;
}

}  // namespace

TidyRecording::TidyRecording(robot::Robot& robot, const report::RunFolder& folder, const Wanted& wanted)
    : robot_(robot), recording_robot_(robot, [this](const robot::Observation& o) { record(o); }) {
  if (wanted.format.empty()) return;
  const recording::RunSetup setup{wanted.seed,    wanted.method,           wanted.floor_clearance_m,
                                  &robot.model(), &wanted.reference.floor, documents(folder, wanted)};
  if (wanted.format != "rawlog") {
    mcap_ = std::make_unique<recording::RunRecorder>(folder.path() / kMcap, setup, wanted.threaded);
  }
  if (wanted.format != "mcap") {
    rawlog_ = std::make_unique<recording::RawlogWriter>(folder.path() / kRawlog, setup, wanted.threaded);
  }
}

void TidyRecording::record(const robot::Observation& observation) {
  if (mcap_) mcap_->record(observation);
  if (rawlog_) rawlog_->record(observation);
}

void TidyRecording::attach(mission::Sinks& sinks, const knowledge::KnowledgeBase& knowledge,
                           std::function<const mapping::VoxelMap&()> voxels) {
  if (mcap_) mcap_->attach(sinks, knowledge, std::move(voxels));
  if (rawlog_) rawlog_->attach(sinks);
}

void TidyRecording::log(Stamp stamp, const std::string& text) {
  if (mcap_) mcap_->log(stamp, text);
}

void TidyRecording::close() {
  if (mcap_) mcap_->close();
  if (rawlog_) rawlog_->close();
}

}  // namespace amiss::app
