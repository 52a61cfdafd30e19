#include "reconstruct_run.hpp"

#include <fmt/format.h>

#include <chrono>
#include <map>
#include <nlohmann/json.hpp>

#include "core/files.hpp"
#include "core/worker.hpp"
#include "dataset/cloud_files.hpp"
#include "dataset/trajectory_files.hpp"
#include "mapping/voxel_files.hpp"

namespace amiss::app {
namespace {

using nlohmann::ordered_json;

/// Adds the time of its life to a number.
class Timed {
 public:
  explicit Timed(double& sum_s) : sum_s_(sum_s) {}
  ~Timed() { sum_s_ += std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count(); }
  Timed(const Timed&) = delete;
  Timed& operator=(const Timed&) = delete;

 private:
  double& sum_s_;
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
};

struct Times {
  double read_s = 0.0, refine_s = 0.0, insert_s = 0.0, extract_s = 0.0, write_s = 0.0, frames_s = 0.0;
};

struct Refinements {
  std::size_t accepted = 0;
  std::map<std::string, std::size_t> refused;
  double shift_sum_m = 0.0, shift_max_m = 0.0, turn_sum_rad = 0.0, turn_max_rad = 0.0;

  void add(const mapping::Refinement& r) {
    if (!r.accepted) {
      ++refused[r.why];
      return;
    }
    ++accepted;
    shift_sum_m += r.shift_m;
    turn_sum_rad += r.turn_rad;
    shift_max_m = std::max(shift_max_m, r.shift_m);
    turn_max_rad = std::max(turn_max_rad, r.turn_rad);
  }
  [[nodiscard]] ordered_json json() const {
    const double n = accepted == 0 ? 1.0 : static_cast<double>(accepted);
    ordered_json why = ordered_json::object();
    for (const auto& [reason, count] : refused) why[reason] = count;
    return {{"accepted", accepted},
            {"refused", why},
            {"mean_shift_m", shift_sum_m / n},
            {"max_shift_m", shift_max_m},
            {"mean_turn_deg", degrees(turn_sum_rad / n)},
            {"max_turn_deg", degrees(turn_max_rad)}};
  }
};

class Run {
 public:
  Run(const ReconstructJob& job, const report::RunFolder& folder)
      : job_(job), folder_(folder), reconstructor_(mapping::make_reconstructor(job.params)) {}

  std::string operator()() {
    {
      const Timed timed(times_.frames_s);
      if (!take_frames()) return "";
    }
    mapping::Reconstruction made = [&] {
      const Timed timed(times_.extract_s);
      return reconstructor_->finish();
    }();
    const mapping::VoxelCounts space = made.space.counts();
    ordered_json report = numbers(made);
    {
      const Timed timed(times_.write_s);
      write(std::move(made));
    }
    const double recorded_s = poses_.size() < 2 ? 0.0 : seconds(poses_.back().stamp - poses_.front().stamp);
    const double whole_s = times_.frames_s + times_.extract_s + times_.write_s;
    report["space"] = {{"voxel_m", job_.params.space_voxels * job_.params.surface.voxel_m},
                       {"free", space.free},
                       {"occupied", space.occupied}};
    report["recorded_s"] = recorded_s;
    report["wall"] = {{"read_s", times_.read_s},
                      {"refine_s", times_.refine_s},
                      {"insert_s", times_.insert_s},
                      {"extract_s", times_.extract_s},
                      {"write_s", times_.write_s},
                      {"whole_s", whole_s},
                      {"frames_per_s", static_cast<double>(poses_.size()) / times_.frames_s}};
    folder_.finish(report.dump(2) + "\n");
    return summary(report, whole_s);
  }

 private:
  /// False when it was stopped.
  bool take_frames() {
    Worker reader(job_.threaded);
    const auto read = [&](std::size_t i) {
      return reader.submit([this, i] {
        const Timed timed(times_.read_s);
        return job_.recording.load(i);
      });
    };
    const std::size_t all = job_.recording.size();
    std::future<dataset::PosedFrame> next = read(0);
    for (std::size_t i = 0; i < all; i += job_.every) {
      if (job_.stop()) return false;
      const dataset::PosedFrame posed = next.get();
      if (i + job_.every < all) next = read(i + job_.every);
      take(posed);
      job_.progress(fmt::format("{} of {} frames", i + 1, all));
    }
    return true;
  }

  void take(const dataset::PosedFrame& posed) {
    Transform<Map, Camera> pose = posed.T_map_camera;
    {
      const Timed timed(times_.refine_s);
      // The first frame has no model to be held against.
      if (!poses_.empty()) {
        if (const auto refinement = reconstructor_->refine(posed.frame, pose)) {
          refinements_.add(*refinement);
          pose = refinement->T_map_camera;
        }
      }
    }
    const Timed timed(times_.insert_s);
    reconstructor_->insert(posed.frame, pose);
    poses_.push_back({posed.frame.stamp, pose});
  }

  [[nodiscard]] ordered_json numbers(const mapping::Reconstruction& made) const {
    ordered_json report = {{"schema", "amiss.reconstruction.1"},
                           {"version", AMISS_VERSION},
                           {"recording", job_.name},
                           {"format", job_.recording.format()},
                           {"method", job_.params.method},
                           {"voxel_m", job_.params.surface.voxel_m},
                           {"frames", poses_.size()},
                           {"frames_without_depth_or_pose", job_.recording.dropped()},
                           {"points", made.cloud.points.size()},
                           {"vertices", made.mesh.vertices.points.size()},
                           {"triangles", made.mesh.triangles.size()}};
    if (job_.params.refine) report["refinement"] = refinements_.json();
    return report;
  }

  void write(mapping::Reconstruction made) const {
    dataset::CloudFile cloud;
    cloud.mesh.vertices = std::move(made.cloud);
    folder_.save("cloud.ply", dataset::ply_bytes(cloud));
    folder_.save("cloud.pcd", dataset::pcd_bytes(cloud));
    if (job_.params.method == "tsdf") {
      cloud.mesh = std::move(made.mesh);
      folder_.save("mesh.ply", dataset::ply_bytes(cloud));
    }
    folder_.save("space.bt", mapping::voxel_map_bytes(made.space, mapping::VoxelFormat::kBt));
    folder_.save("trajectory.txt", dataset::tum_trajectory_bytes(poses_));
  }

  [[nodiscard]] std::string summary(const ordered_json& report, double whole_s) const {
    return fmt::format(
        "{} frames ({}), {} points, {} triangles in {:.1f} s ({:.1f} frames a second)\nreconstruction: {}\n",
        poses_.size(), job_.recording.format(), report["points"].get<std::size_t>(),
        report["triangles"].get<std::size_t>(), whole_s, static_cast<double>(poses_.size()) / whole_s,
        folder_.path().string());
  }

  const ReconstructJob& job_;
  const report::RunFolder& folder_;
  std::unique_ptr<mapping::Reconstructor> reconstructor_;
  std::vector<dataset::StampedPose> poses_;
  Refinements refinements_;
  Times times_;
};

}  // namespace

std::string reconstruct(const ReconstructJob& job, const report::RunFolder& folder) { return Run(job, folder)(); }

}  // namespace amiss::app
