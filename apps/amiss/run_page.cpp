#include "run_page.hpp"

#include <iostream>
#include <thread>

#include "core/files.hpp"
#include "interrupt.hpp"
#include "library_versions.hpp"
#include "page/report_page.hpp"
#include "page/run_files.hpp"

namespace amiss::app {

namespace {

Pose2<Map, Base> on_map(const Transform<World, Map>& T_world_map, const Pose2<World, Base>& T_world_base) {
  const Eigen::Isometry3d T = (T_world_map.inverse() * T_world_base.lift()).T;
  return {T.translation().x(), T.translation().y(), std::atan2(T.linear()(1, 0), T.linear()(0, 0))};
}

std::vector<page::PlacedObject> placed_objects(const RunPage::Watched& watched) {
  std::vector<page::PlacedObject> objects;
  const Transform<Map, World> T_map_world = watched.T_world_map.inverse();
  for (const score::ObjectVerdict& v : watched.referee.verdicts()) {
    objects.push_back({v.name, v.kind, T_map_world * Point<World>{v.position_world}, v.found, v.covered, v.found_at_s,
                       v.error_m, v.cover, v.purity});
  }
  return objects;
}

std::vector<page::Touch> touches(const RunPage::Watched& watched) {
  std::vector<page::Touch> list;
  const Transform<Map, World> T_map_world = watched.T_world_map.inverse();
  for (const world::Collision& c : watched.simulator.collisions()) {
    list.push_back({c.stamp, c.link, c.body, T_map_world * c.position});
  }
  return list;
}

std::vector<page::MovableBody> movable_bodies(const RunPage::Watched& watched) {
  std::vector<page::MovableBody> list;
  const Transform<Map, World> T_map_world = watched.T_world_map.inverse();
  for (world::ObjectTruth& o : watched.simulator.truth().objects) {
    list.push_back({std::move(o.name), std::move(o.kind), T_map_world * o.pose});
  }
  return list;
}

std::vector<page::Occurrence> occurrences(const RunPage::Watched& watched) {
  std::vector<page::Occurrence> list;
  if (watched.script == nullptr) return list;
  for (const sim::Happening& h : watched.script->happened()) list.push_back({h.stamp, h.what});
  return list;
}

}  // namespace

RunPage::RunPage(const report::RunFolder& folder, const ViewOptions& options, bool threaded)
    : folder_(folder), recorder_(folder.path(), history_, threaded) {
  if (!options.wanted) return;
  pace_.set_speed(options.speed);
  server_ = std::make_unique<page::Server>(options.server, page::served_files(folder.path()), history_, &pace_);
  announce(*server_, options);
}

void RunPage::begin(const page::Beginning& beginning, const Watched& watched,
                    std::function<const mapping::VoxelMap&()> voxels) {
  page::Onlooker onlooker;
  onlooker.true_pose = [watched] { return on_map(watched.T_world_map, watched.simulator.truth().T_world_base); };
  onlooker.objects = [watched] { return placed_objects(watched); };
  onlooker.collisions = [watched] { return touches(watched); };
  onlooker.bodies = [watched] { return movable_bodies(watched); };
  onlooker.script = [watched] { return occurrences(watched); };
  onlooker.knowledge = [watched]() -> const knowledge::Knowledge& { return watched.knowledge.now(); };
  onlooker.voxels = std::move(voxels);
  recorder_.begin(beginning, std::move(onlooker));
  begun_ = true;
}

void RunPage::attach(mission::Sinks& sinks) {
  recorder_.attach(sinks);
  if (!server_) return;
  sinks.step = [this, before = std::move(sinks.step), stop = sinks.stop](const mission::StepEvent& event) {
    before(event);
    pace_.wait(event.pose.stamp, stop);
  };
}

void RunPage::settle() { recorder_.settle(); }

void RunPage::end(const std::string& report_json) {
  if (!begun_) return;
  recorder_.end(report_json);
  const page::ReportPage report{history_.lines(),
                                [this](page::Slice slice) { return page::load_picture(folder_.path(), slice); },
                                {{"params.yaml", load_bytes(folder_.path() / "params.yaml")}},
                                library_versions()};
  folder_.save("report.html", page::to_html(report));
}

void RunPage::linger() const {
  if (server_ && server_->watchers() > 0) std::cerr << "amiss: the run is over; close its page or press Ctrl+C\n";
  while (server_ && server_->watchers() > 0 && !interrupted())
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
}

}  // namespace amiss::app
