// Writes down what a run does while it does it: Sinks -> timeline.jsonl (one event a line, see events.hpp) and
// camera.bin (JPEG pictures one after the other) in the run folder, and the same lines into a History for pages that
// watch. Poses and what moved five times and pictures once in a simulated second, everything else when it changes. The
// same run writes the same bytes, watched or not, but for the report in its last line. A run that is killed leaves all
// but what the operating system had not written. std::runtime_error where the folder cannot be written.
#pragma once

#include <fstream>
#include <functional>
#include <future>
#include <map>
#include <optional>

#include "core/worker.hpp"
#include "page/events.hpp"
#include "page/history.hpp"

namespace amiss::page {

/// What a recorder is shown beside the sinks; the app knows it. Each is asked at times of the recorder's choice.
struct Onlooker {
  std::function<Pose2<Map, Base>()> true_pose;
  std::function<std::vector<PlacedObject>()> objects;
  std::function<std::vector<Touch>()> collisions;                                              // all so far
  std::function<std::vector<MovableBody>()> bodies;                                            // all that are there
  std::function<std::vector<Occurrence>()> script = [] { return std::vector<Occurrence>(); };  // all so far
  std::function<const knowledge::Knowledge&()> knowledge;
  std::function<const mapping::VoxelMap&()> voxels;
};

class Recorder {
 public:
  /// `threaded`: pictures are compressed beside the run.
  Recorder(const std::filesystem::path& folder, History& history, bool threaded);
  ~Recorder();
  Recorder(const Recorder&) = delete;
  Recorder& operator=(const Recorder&) = delete;

  void begin(const Beginning& beginning, Onlooker onlooker);
  /// Listens to these sinks too; what was attached before is called first. The recorder outlives the sinks.
  void attach(mission::Sinks& sinks);
  /// What is still to be told of the run; the onlooker is asked a last time.
  void settle();
  /// Nothing comes after this.
  void end(std::string_view report_json);

  static constexpr const char* kTimeline = "timeline.jsonl";
  static constexpr const char* kCamera = "camera.bin";

 private:
  struct Pictures {
    Stamp taken;
    std::string colour, depth;
  };
  void write(std::string line);
  Slice keep(std::string_view jpeg);
  void on_step(const mission::StepEvent& event);
  void on_frame(const mission::FrameEvent& event);
  void on_examined(const mission::ExaminationEvent& event);
  void on_compared(const mission::DifferenceEvent& event);
  void on_progress(const mission::ProgressEvent& event);
  void write_frame();
  void write_voxels();
  void write_knowledge();
  void write_objects();
  void write_collisions();
  void write_bodies();
  void write_script();

  History& history_;
  std::filesystem::path folder_;
  std::ofstream timeline_, camera_;
  std::size_t camera_bytes_ = 0;
  Onlooker onlooker_;
  Stamp now_, next_pose_, next_frame_, next_voxels_, next_progress_;
  std::optional<std::future<Pictures>> compressing_;
  std::map<mapping::BlockKey, mapping::BlockBits> told_voxels_;
  std::uint64_t told_revision_ = 0;
  change::Difference told_difference_;
  std::string told_regions_, told_views_;  // without their stamps
  std::vector<PlacedObject> told_objects_;
  std::size_t told_collisions_ = 0, told_script_ = 0;
  std::map<std::string, Eigen::Isometry3d> told_bodies_;  // by name
  Worker worker_;
};

}  // namespace amiss::page
