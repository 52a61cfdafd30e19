#include "dataset_jobs.hpp"

#include <fmt/format.h>

#include <charconv>

#include "commands.hpp"
#include "core/result.hpp"
#include "dataset_record.hpp"
#include "interrupt.hpp"
#include "sim/scatter.hpp"

namespace amiss::app {

namespace {

namespace fs = std::filesystem;

/// A folder that is made beside its place and renamed when it is whole; `make` says whether it is.
template <class Make>
bool make_whole(const fs::path& folder, const Make& make) {
  if (fs::exists(folder)) return true;
  const fs::path making = folder.parent_path() / ("." + folder.filename().string() + ".making");
  fs::remove_all(making);
  fs::create_directories(making);
  if (!make(making)) return false;
  fs::rename(making, folder);
  return true;
}

/// "place/big_room/6" -> its three words.
struct JobName {
  std::string what, room;
  std::size_t number = 0;
};
JobName parsed(const std::string& job) {
  const std::size_t first = job.find('/'), last = job.rfind('/');
  JobName name;
  const char* end = job.data() + job.size();
  if (first != last && last != std::string::npos &&
      std::from_chars(job.data() + last + 1, end, name.number).ptr == end) {
    name.what = job.substr(0, first);
    name.room = job.substr(first + 1, last - first - 1);
    return name;
  }
  throw ArgumentError("--child " + job + ": 'map/ROOM/0', 'place/ROOM/VISITS' or 'record/ROOM/VISIT' is needed");
}

}  // namespace

DatasetJobs::DatasetJobs(fs::path out, const DatasetSettings& settings, std::uint64_t seed, bool rawlog)
    : out_(std::move(out)), settings_(settings), seed_(seed), rawlog_(rawlog), resources_(find_resources()) {}

fs::path DatasetJobs::placement(const std::string& room, std::size_t visit) const {
  return out_ / "placements" / room / scene_name(visit);
}
fs::path DatasetJobs::recording(const std::string& room, std::size_t visit) const {
  return out_ / "recordings" / room / scene_name(visit);
}

bool DatasetJobs::all_placed(const world::RoomPlan& plan) const {
  for (std::size_t k = 0; k <= plan.objects.size(); ++k) {
    if (!fs::exists(placement(plan.world, k))) return false;
  }
  return true;
}

std::vector<std::string> DatasetJobs::visits(const std::vector<world::RoomPlan>& plans) const {
  std::vector<std::string> jobs;
  for (const world::RoomPlan& plan : plans) {
    for (std::size_t k = 0; k <= plan.objects.size(); ++k) {
      if (!fs::exists(recording(plan.world, k))) jobs.push_back(fmt::format("record/{}/{}", plan.world, k));
    }
  }
  return jobs;
}

std::vector<std::string> DatasetJobs::preparations(const std::vector<world::RoomPlan>& plans) const {
  std::vector<std::string> jobs;
  for (const world::RoomPlan& plan : plans) {
    if (visits({plan}).empty()) continue;
    jobs.push_back(fmt::format("map/{}/0", plan.world));
    if (!all_placed(plan)) jobs.push_back(fmt::format("place/{}/{}", plan.world, plan.objects.size()));
  }
  return jobs;
}

int DatasetJobs::run(const std::string& job) const {
  const JobName name = parsed(job);
  const DatasetRoom room =
      load_room(resources_, chosen_rooms(resources_, {name.room}, std::nullopt).front(), settings_);
  if (name.what == "map") return map(room);
  if (name.what == "place") return place(room, name.number);
  if (name.what == "record") return record(room, name.number);
  throw ArgumentError("--child " + job + ": is no part of a data set");
}

int DatasetJobs::place(const DatasetRoom& room, std::size_t visits) const {
  DatasetRoom fewer = room;
  fewer.plan.objects.resize(std::min(visits, room.plan.objects.size()));
  const std::vector<sim::Visit> placed = place_objects(fewer, settings_, seed_);
  for (std::size_t k = 0; k <= placed.size(); ++k) {
    make_whole(placement(room.plan.world, k), [&](const fs::path& folder) {
      save_visit(folder, k == 0 ? sim::Visit() : placed[k - 1]);
      return true;
    });
  }
  return kGoalMet;
}

/// The map of the tidy room, made with the torso down and shared with all other runs in this room.
std::optional<PreparedReference> DatasetJobs::reference(const DatasetRoom& room) const {
  Settings settings = settings_.run;
  mission::Sinks sinks;
  sinks.stop = interrupted;
  const robot::Model model = robot::load_model(resources_.robot);
  return cached_reference({room.world, model, room.start, resources_.robot}, settings, false, sinks, [] {});
}

int DatasetJobs::map(const DatasetRoom& room) const {
  if (reference(room)) return kGoalMet;
  if (interrupted()) return kInterrupted;
  throw InputError(room.world.file.string() + ": could not be mapped to the end");
}

int DatasetJobs::record(const DatasetRoom& room, std::size_t visit) const {
  const std::optional<PreparedReference> prepared = reference(room);
  if (!prepared) return kInterrupted;
  const sim::Visit content = load_visit(placement(room.plan.world, visit), room);
  const std::uint64_t seed = RandomStream(seed_, "dataset/" + room.plan.world + "/" + scene_name(visit)).next() >> 16U;
  const bool whole = make_whole(recording(room.plan.world, visit), [&](const fs::path& folder) {
    return record_visit({room, settings_, *prepared, content, scene_name(visit), seed, rawlog_}, folder);
  });
  if (whole) return kGoalMet;
  if (interrupted()) return kInterrupted;
  throw InputError(room.world.file.string() + ": the tour did not come to its end");
}

std::vector<std::filesystem::path> DatasetJobs::recordings(const std::vector<world::RoomPlan>& plans) const {
  std::vector<std::filesystem::path> folders;
  for (const world::RoomPlan& plan : plans) {
    for (std::size_t k = 0; k <= plan.objects.size(); ++k) folders.push_back(recording(plan.world, k));
  }
  return folders;
}

std::vector<std::string> DatasetJobs::shortfalls(const std::vector<world::RoomPlan>& plans) const {
  const world::Catalogue catalogue = world::load_catalogue({resources_.objects}, settings_.run.world);
  std::vector<std::string> told;
  for (const world::RoomPlan& plan : plans) {
    for (std::size_t k = 0; k < plan.objects.size(); ++k) {
      const fs::path placed = placement(plan.world, k + 1) / "objects.yaml";
      if (!fs::exists(placed)) continue;  // of a run that was stopped, or only recordings were kept
      const std::size_t there = sim::load_scatter(placed, catalogue).size();
      if (there >= static_cast<std::size_t>(plan.objects[k])) continue;
      told.push_back(
          fmt::format("{}/{}: {} of {} objects found a place", plan.world, scene_name(k + 1), there, plan.objects[k]));
    }
  }
  return told;
}

std::string DatasetJobs::summary(const std::vector<world::RoomPlan>& plans) const {
  const world::Catalogue catalogue = world::load_catalogue({resources_.objects}, settings_.run.world);
  const auto folders = recordings(plans);
  std::size_t objects = 0;
  for (const auto& folder : folders) {
    objects += sim::load_scatter(folder / "truth" / "objects.yaml", catalogue).size();
  }
  return fmt::format("{} recordings with {} objects", folders.size(), objects);
}

}  // namespace amiss::app
