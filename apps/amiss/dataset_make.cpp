#include "dataset_make.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <iostream>

#include "commands.hpp"
#include "core/files.hpp"
#include "core/result.hpp"
#include "dataset_record.hpp"
#include "dataset_rooms.hpp"
#include "interrupt.hpp"
#include "job_pool.hpp"
#include "reference_cache.hpp"

namespace amiss::app {

namespace {

namespace fs = std::filesystem;

constexpr std::string_view kFormat = "dataset 1";

/// What a data set in this folder is made of; a folder of another one is refused.
void claim(const fs::path& folder, const DatasetOptions& options, DatasetSettings& settings) {
  const std::string text = fmt::format("# {}, amiss {}\n# seed {}\n{}", kFormat, AMISS_VERSION, options.seed,
                                       settings.table().to_yaml());
  const fs::path file = folder / "dataset.yaml";
  if (!fs::exists(file)) {
    if (fs::exists(folder) && !fs::is_empty(folder)) {
      throw ArgumentError(folder.string() + ": holds something else; a new or empty folder is needed");
    }
    fs::create_directories(folder);
    save_atomically(file, text);
  } else if (load_bytes(file) != text) {
    throw ArgumentError(file.string() + ": made with another seed, other parameters or another version; use another "
                        "folder or the same ones");
  }
}

/// A folder that is made beside its place and renamed when it is whole.
template <class Make>
void make_whole(const fs::path& folder, const Make& make) {
  if (fs::exists(folder)) return;
  const fs::path making = folder.parent_path() / ("." + folder.filename().string() + ".making");
  fs::remove_all(making);
  fs::create_directories(making);
  if (make(making)) fs::rename(making, folder);
}

class Maker {
 public:
  Maker(const DatasetOptions& options, DatasetSettings settings)
      : options_(options), settings_(std::move(settings)), out_(options.out), resources_(find_resources()) {}

  int run() {
    const std::vector<world::RoomPlan> plans = chosen_rooms(resources_, options_.rooms, options_.visits);
    std::vector<Job> first, second;
    for (const world::RoomPlan& plan : plans) {
      first.push_back({plan.world + " placements", [this, plan] { return place(plan); }});
      if (!options_.place_only) first.push_back({plan.world + " map", [this, plan] { return map(plan); }});
      for (std::size_t visit = 0; visit <= plan.objects.size() && !options_.place_only; ++visit) {
        if (fs::exists(recording(plan, visit))) continue;
        second.push_back({plan.world + "/" + scene_name(visit), [this, plan, visit] { return record(plan, visit); }});
      }
    }
    for (const std::vector<Job>* jobs : {&first, &second}) {
      const auto results = run_jobs(*jobs, options_.jobs, [this](const JobResult& r) { tell(r); });
      if (interrupted()) return kInterrupted;
      for (const JobResult& result : results) {
        if (result.status != kGoalMet) return result.status;
      }
    }
    return kGoalMet;
  }

 private:
  [[nodiscard]] fs::path placement(const world::RoomPlan& plan, std::size_t visit) const {
    return out_ / "placements" / plan.world / scene_name(visit);
  }
  [[nodiscard]] fs::path recording(const world::RoomPlan& plan, std::size_t visit) const {
    return out_ / "recordings" / plan.world / scene_name(visit);
  }
  void tell(const JobResult& result) const {
    if (!options_.quiet) std::cerr << "amiss: " << result.name << (result.status == 0 ? " done\n" : " failed\n");
  }

  [[nodiscard]] int place(const world::RoomPlan& plan) const {
    bool all_there = true;
    for (std::size_t k = 0; k <= plan.objects.size(); ++k) all_there &= fs::exists(placement(plan, k));
    if (all_there) return kGoalMet;
    const DatasetRoom room = load_room(resources_, plan, settings_);
    const std::vector<sim::Visit> visits = place_objects(room, settings_, options_.seed);
    for (std::size_t k = 0; k <= visits.size(); ++k) {
      make_whole(placement(plan, k), [&](const fs::path& folder) {
        save_visit(folder, k == 0 ? sim::Visit() : visits[k - 1]);
        return true;
      });
    }
    return kGoalMet;
  }

  /// The map of the tidy room, made with the torso down and shared with all other runs in this room.
  [[nodiscard]] std::optional<PreparedReference> reference(const DatasetRoom& room) const {
    Settings settings = settings_.run;
    mission::Sinks sinks;
    sinks.stop = interrupted;
    const robot::Model model = robot::load_model(resources_.robot);
    return cached_reference({room.world, model, room.start, resources_.robot}, settings, false, sinks, [] {});
  }

  [[nodiscard]] int map(const world::RoomPlan& plan) const {
    if (reference(load_room(resources_, plan, settings_))) return kGoalMet;
    return interrupted() ? kInterrupted : kGoalNotMet;
  }

  [[nodiscard]] int record(const world::RoomPlan& plan, std::size_t visit) const {
    const DatasetRoom room = load_room(resources_, plan, settings_);
    const std::optional<PreparedReference> prepared = reference(room);
    if (!prepared) return kInterrupted;
    const fs::path placed = placement(plan, visit);
    const sim::Visit content = load_visit(placed, room);
    bool whole = false;
    make_whole(recording(plan, visit), [&](const fs::path& folder) {
      const std::uint64_t seed =
          RandomStream(options_.seed, "dataset/" + plan.world + "/" + scene_name(visit)).next() >> 16U;
      whole = record_visit({room, settings_, *prepared, content, seed}, folder);
      return whole;
    });
    if (whole) return kGoalMet;
    return interrupted() ? kInterrupted : kGoalNotMet;
  }

  const DatasetOptions& options_;
  DatasetSettings settings_;
  fs::path out_;
  Resources resources_;
};

}  // namespace

int make_dataset(const DatasetOptions& options) {
  catch_interrupts();
  DatasetSettings settings = load_dataset_settings(options.params_file, options.overrides);
  claim(options.out, options, settings);
  return Maker(options, std::move(settings)).run();
}

}  // namespace amiss::app
