#include "localize/internal/scan_search.hpp"

#include <algorithm>
#include <limits>
#include <optional>

namespace amiss::localize::internal {

namespace {

// The window: poses to each side of the prior, and the distance between two.
constexpr int kShifts = 2;
constexpr double kShiftM = 0.05;
constexpr int kTurns = 3;
constexpr double kTurnRad = 0.015;
constexpr std::size_t kPoints = 80;    // about, of a scan
constexpr double kNearlyAsGood = 1.6;  // times the best cost

struct Candidate {
  int x = 0, y = 0, turn = 0;  // steps from the prior
  double cost = std::numeric_limits<double>::infinity();
};

bool elsewhere(const Candidate& a, const Candidate& b) {
  return std::max({std::abs(a.x - b.x), std::abs(a.y - b.y), std::abs(a.turn - b.turn)}) > 1;
}

/// Indices of the points' cells; points that a shift would carry off the map have no say.
std::vector<std::size_t> cells_of(const FloorGrid& frame, const std::vector<Eigen::Vector2d>& points_base,
                                  const Pose2<Map, Base>& pose, int margin) {
  const std::size_t stride = std::max<std::size_t>(1, points_base.size() / kPoints);
  const Eigen::Matrix2d R = Eigen::Rotation2Dd(pose.yaw_rad).toRotationMatrix();
  std::vector<std::size_t> cells;
  cells.reserve(points_base.size() / stride + 1);
  for (std::size_t i = 0; i < points_base.size(); i += stride) {
    const Cell c = frame.cell_at(R * points_base[i] + pose.position());
    if (frame.contains({c.x - margin, c.y - margin}) && frame.contains({c.x + margin, c.y + margin})) {
      cells.push_back(frame.index(c));
    }
  }
  return cells;
}

}  // namespace

std::vector<Pose2<Map, Base>> best_in_window(const DistanceField& field,
                                             const std::vector<Eigen::Vector2d>& points_base,
                                             const AlignmentPrior& prior) {
  const FloorGrid& frame = field.map();
  const int cells_a_shift = std::max(1, static_cast<int>(std::lround(kShiftM / frame.resolution_m())));
  const double shift_m = cells_a_shift * frame.resolution_m();
  const auto offset_of = [&](const Candidate& c) {
    return Eigen::Vector3d(c.x * shift_m, c.y * shift_m, c.turn * kTurnRad);
  };
  std::vector<Candidate> candidates;
  candidates.reserve((2 * kShifts + 1) * (2 * kShifts + 1) * (2 * kTurns + 1));
  for (int turn = -kTurns; turn <= kTurns; ++turn) {
    const Pose2<Map, Base> turned = moved(prior.T_map_base, {0.0, 0.0, turn * kTurnRad});
    const auto cells = cells_of(frame, points_base, turned, kShifts * cells_a_shift);
    if (cells.empty()) continue;
    const double scale = static_cast<double>(points_base.size()) / static_cast<double>(cells.size());
    for (int y = -kShifts; y <= kShifts; ++y) {
      for (int x = -kShifts; x <= kShifts; ++x) {
        const float* costs = field.cell_costs().data() + (y * frame.width() + x) * cells_a_shift;
        float sum = 0.0F;
        for (const std::size_t cell : cells) sum += costs[cell];
        Candidate candidate{x, y, turn};
        candidate.cost = scale * static_cast<double>(sum) + prior_cost(prior, offset_of(candidate));
        candidates.push_back(candidate);
      }
    }
  }
  Candidate best, second;
  for (const Candidate& c : candidates) {
    if (c.cost < best.cost) best = c;
  }
  for (const Candidate& c : candidates) {
    if (c.cost < second.cost && elsewhere(c, best)) second = c;
  }
  std::vector<Pose2<Map, Base>> poses{moved(prior.T_map_base, offset_of(best))};
  if (second.cost < kNearlyAsGood * best.cost) poses.push_back(moved(prior.T_map_base, offset_of(second)));
  return poses;
}

}  // namespace amiss::localize::internal
