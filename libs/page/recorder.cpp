#include "page/recorder.hpp"

#include <algorithm>
#include <stdexcept>

#include "page/picture.hpp"

namespace amiss::page {

namespace {

constexpr Duration kPosePeriod = std::chrono::milliseconds(200);
constexpr Duration kFramePeriod = std::chrono::seconds(1);
constexpr Duration kVoxelPeriod = std::chrono::seconds(1);
constexpr Duration kProgressPeriod = std::chrono::seconds(1);
constexpr double kMoved = 2e-3;  // of an element of the matrix: 2 mm, 0.1 degrees

/// `next` is due at `now`: it moves on by whole periods.
bool due(Stamp now, Stamp& next, Duration period) {
  if (now < next) return false;
  while (next <= now) next += period;
  return true;
}

std::ofstream open(const std::filesystem::path& file) {
  std::ofstream stream(file, std::ios::binary | std::ios::trunc);
  if (!stream) throw std::runtime_error(file.string() + ": cannot be written");
  return stream;
}

/// Runs `before`, then `after`, for each event.
template <class Event, class After>
void chain(std::function<void(const Event&)>& sink, After after) {
  sink = [before = std::move(sink), after](const Event& event) {
    before(event);
    after(event);
  };
}

}  // namespace

Recorder::Recorder(const std::filesystem::path& folder, History& history, bool threaded)
    : history_(history),
      folder_(folder),
      timeline_(open(folder / kTimeline)),
      camera_(open(folder / kCamera)),
      worker_(threaded) {}

Recorder::~Recorder() = default;

void Recorder::begin(const Beginning& beginning, Onlooker onlooker) {
  onlooker_ = std::move(onlooker);
  write(start_line(beginning));
  write_objects();
  write_bodies();
}

void Recorder::attach(mission::Sinks& sinks) {
  chain<mission::StepEvent>(sinks.step, [this](const auto& e) { on_step(e); });
  chain<mission::FrameEvent>(sinks.frame, [this](const auto& e) { on_frame(e); });
  chain<mission::ExaminationEvent>(sinks.examined, [this](const auto& e) { on_examined(e); });
  chain<mission::PlanEvent>(sinks.planned, [this](const auto& e) {
    write_knowledge();
    write(plan_line(e));
  });
  chain<mission::ActionEvent>(sinks.acting, [this](const auto& e) { write(step_line(e)); });
  chain<mission::PathEvent>(sinks.path, [this](const auto& e) { write(path_line(e)); });
  chain<mission::DifferenceEvent>(sinks.compared, [this](const auto& e) { on_compared(e); });
  chain<mission::ProgressEvent>(sinks.progress, [this](const auto& e) { on_progress(e); });
  sinks.log = [this, before = std::move(sinks.log)](Stamp stamp, const std::string& text) {
    before(stamp, text);
    write(log_line(stamp, text));
  };
}

void Recorder::settle() {
  write_frame();
  write_voxels();
  write_knowledge();
  write_objects();
  write_collisions();
  write_bodies();
  write_script();
}

void Recorder::end(std::string_view report_json) {
  write(end_line(now_, report_json));
  timeline_.close();
  camera_.close();
  if (!timeline_ || !camera_) throw std::runtime_error(folder_.string() + ": the timeline cannot be written");
}

void Recorder::write(std::string line) {
  timeline_ << line << '\n';
  if (!timeline_) throw std::runtime_error((folder_ / kTimeline).string() + ": cannot be written");
  history_.append(std::move(line));
}

Slice Recorder::keep(std::string_view jpeg) {
  camera_.write(jpeg.data(), static_cast<std::streamsize>(jpeg.size()));
  camera_.flush();  // before a page is told of it
  if (!camera_) throw std::runtime_error((folder_ / kCamera).string() + ": cannot be written");
  const Slice slice{camera_bytes_, jpeg.size()};
  camera_bytes_ += jpeg.size();
  return slice;
}

void Recorder::on_step(const mission::StepEvent& event) {
  now_ = event.pose.stamp;
  if (!due(now_, next_pose_, kPosePeriod)) return;
  write_frame();
  write(pose_line(event, onlooker_.true_pose()));
  write_collisions();
  write_bodies();
  write_script();
  write_objects();
  if (due(now_, next_voxels_, kVoxelPeriod)) write_voxels();
  timeline_.flush();
}

void Recorder::on_frame(const mission::FrameEvent& event) {
  if (!due(event.frame->stamp, next_frame_, kFramePeriod)) return;
  write_frame();
  compressing_ = worker_.submit([small = half_size(*event.frame)] {
    return Pictures{small.stamp, colour_jpeg(small), depth_jpeg(small)};
  });
}

void Recorder::write_frame() {
  if (!compressing_) return;
  const Pictures pictures = compressing_->get();
  compressing_.reset();
  const Slice colour = keep(pictures.colour);
  write(frame_line(pictures.taken, colour, keep(pictures.depth)));
}

void Recorder::on_examined(const mission::ExaminationEvent& event) {
  write(examined_line(event, keep(segments_jpeg(*event.frame, *event.segments))));
  write_knowledge();
  write_objects();
}

void Recorder::write_voxels() {
  const mapping::VoxelMap& map = onlooker_.voxels();
  const auto changed = map.blocks_changed_since(told_revision_);
  told_revision_ = map.revision();
  std::vector<mapping::Voxel> on, off;
  for (const mapping::BlockKey& key : changed) {
    const mapping::ValueBlock* block = map.values().block(key);
    if (key.z < 0 || block == nullptr) continue;  // the floor would hide all
    mapping::BlockBits& told = told_voxels_[key];
    mapping::BlockBits appeared{}, gone{};
    for (std::size_t i = 0; i < told.size(); ++i) {
      appeared[i] = block->occupied[i] & ~told[i];
      gone[i] = told[i] & ~block->occupied[i];
    }
    mapping::for_each_bit(key, appeared, [&](mapping::Voxel v) { on.push_back(v); });
    mapping::for_each_bit(key, gone, [&](mapping::Voxel v) { off.push_back(v); });
    told = block->occupied;
  }
  if (!on.empty() || !off.empty()) write(voxels_line(now_, on, off));
}

void Recorder::on_compared(const mission::DifferenceEvent& event) {
  const change::Difference& now = *event.difference;
  if (now.appeared == told_difference_.appeared && now.vanished == told_difference_.vanished) return;
  told_difference_ = now;
  write(difference_line(event.stamp, now));
}

void Recorder::on_progress(const mission::ProgressEvent& event) {
  write_knowledge();
  if (!due(event.stamp, next_progress_, kProgressPeriod)) return;
  const auto found = std::count_if(told_objects_.begin(), told_objects_.end(), [](const auto& o) { return o.found; });
  write(progress_line(event, static_cast<int>(found)));
}

void Recorder::write_knowledge() {
  const knowledge::Knowledge& known = onlooker_.knowledge();
  std::string regions = regions_line(Stamp{}, known.regions), views = views_line(Stamp{}, known.views);
  if (regions != told_regions_) {
    told_regions_ = std::move(regions);
    write(regions_line(now_, known.regions));
  }
  if (views != told_views_) {
    told_views_ = std::move(views);
    write(views_line(now_, known.views));
  }
}

void Recorder::write_objects() {
  std::vector<PlacedObject> objects = onlooker_.objects();
  if (objects == told_objects_) return;
  told_objects_ = std::move(objects);
  write(objects_line(now_, told_objects_));
}

void Recorder::write_collisions() {
  const std::vector<Touch> touches = onlooker_.collisions();
  for (; told_collisions_ < touches.size(); ++told_collisions_) write(collision_line(touches[told_collisions_]));
}

void Recorder::write_bodies() {
  std::vector<MovableBody> moved;
  std::map<std::string, Eigen::Isometry3d> now;
  for (MovableBody& body : onlooker_.bodies()) {
    const auto told = told_bodies_.find(body.name);
    const bool same = told != told_bodies_.end() &&
                      (told->second.matrix() - body.T_map_body.T.matrix()).cwiseAbs().maxCoeff() < kMoved;
    now[body.name] = same ? told->second : body.T_map_body.T;
    if (!same) moved.push_back(std::move(body));
  }
  std::vector<std::string> gone;
  for (const auto& [name, T] : told_bodies_) {
    if (!now.contains(name)) gone.push_back(name);
  }
  told_bodies_ = std::move(now);
  if (!moved.empty() || !gone.empty()) write(bodies_line(now_, moved, gone));
}

void Recorder::write_script() {
  const std::vector<Occurrence> occurrences = onlooker_.script();
  for (; told_script_ < occurrences.size(); ++told_script_) write(script_line(occurrences[told_script_]));
}

}  // namespace amiss::page
