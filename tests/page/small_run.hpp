// A run of a few seconds as a mission would tell it, with a robot, a map of some voxels and one object.
#pragma once

#include "core/temporary_folder.hpp"
#include "page/recorder.hpp"

namespace amiss::test {

class SmallRun {
 public:
  SmallRun() {
    for (int x = 2; x < 8; ++x) {
      for (int y = 2; y < 8; ++y) floor.set({x, y}, y == 7 ? Occupancy::kOccupied : Occupancy::kFree);
    }
    reference.set({1, 2, 3}, Occupancy::kOccupied);
    reference.set({1, 2, -1}, Occupancy::kOccupied);
    objects.push_back({"mug", "mug", {{1.0, 2.0, 0.05}}, false, false, 0.0, 0.0, 0.0, 0.0});
    frame.intrinsics = {32, 24, 30.0, 30.0, 16.0, 12.0};
    frame.colour.assign(32 * 24, {200, 100, 50});
    frame.depth_m.assign(32 * 24, 1.5F);
  }

  /// The timeline of `seconds_s` seconds, in `folder`. The events call the sinks as Perception and Search do.
  void record(const std::filesystem::path& folder, page::History& history, double seconds_s, bool threaded = false) {
    page::Recorder recorder(folder, history, threaded);
    mission::Sinks sinks;
    sinks.step = [this](const mission::StepEvent&) { ++steps_before; };
    recorder.attach(sinks);
    page::Onlooker onlooker;
    onlooker.true_pose = [] { return Pose2<Map, Base>{0.5, 0.25, 0.0}; };
    onlooker.objects = [this] { return objects; };
    onlooker.collisions = [this] { return touches; };
    onlooker.bodies = [this] { return bodies; };
    onlooker.script = [this] { return script; };
    onlooker.knowledge = [this]() -> const knowledge::Knowledge& { return knowledge.now(); };
    onlooker.voxels = [this]() -> const mapping::VoxelMap& { return current; };
    recorder.begin({"0.0.0", "lab", "dynamic", 7, &floor, &reference, &model, 0.1, 0.5, 0.5, place}, onlooker);
    for (int i = 1; i * 0.02 <= seconds_s + 1e-9; ++i) {
      now = Stamp(std::chrono::milliseconds(20 * i));
      if (during) during(sinks, i);
      if (i % 10 == 0) {
        frame.stamp = now;
        sinks.frame({&frame, {}});
      }
      mission::StepEvent step;
      step.pose.stamp = now;
      step.pose.T_map_base = {0.01 * i, 0.0, 0.1};
      step.head = {0.2, -0.4};
      sinks.step(step);
    }
    recorder.settle();
    recorder.end(R"({"outcome":"explored","objects_found":1})");
  }

  FloorGrid floor{0.5, {-1.0, -1.0}, 10, 10};
  mapping::VoxelMap reference, current;
  robot::Model model = robot::load_model(std::filesystem::path(AMISS_SOURCE_DIR) / "robot_model" / "hsr.urdf");
  knowledge::KnowledgeBase knowledge{knowledge::Params()};
  std::vector<page::PlacedObject> objects;
  std::vector<page::Touch> touches;
  std::vector<page::MovableBody> bodies;
  page::Place place{"lab", "", {}};
  std::vector<page::Occurrence> script;
  RgbdFrame frame;
  Stamp now;
  int steps_before = 0;
  std::function<void(mission::Sinks&, int)> during;  // at each period, before its step
};

}  // namespace amiss::test
