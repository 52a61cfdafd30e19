#include "score/referee.hpp"

#include <algorithm>

namespace amiss::score {

void describe(ParamTable& table, RefereeParams& p) {
  table.number("referee.max_error", p.max_error_m, "m", 0.01, 1.0, "of the centre of a segment that counts as found");
  table.number("referee.min_cover", p.min_cover, "", 0.05, 1.0, "part of the object's pixels that the segment holds");
  table.number("referee.min_purity", p.min_purity, "", 0.05, 1.0, "part of the segment's pixels that show the object");
  table.number("referee.region_margin", p.region_margin_m, "m", 0.0, 1.0, "a region so near to an object is not false");
}

Referee::Referee(const std::vector<world::ObjectTruth>& placed, const Transform<World, Map>& T_world_map,
                 const RefereeParams& params)
    : T_world_map_(T_world_map), params_(params) {
  for (const world::ObjectTruth& object : placed) place(object);
}

void Referee::place(const world::ObjectTruth& object) {
  ObjectVerdict verdict;
  verdict.name = object.name;
  verdict.kind = object.kind;
  verdict.position_world = object.bounds.center();
  verdicts_.push_back(std::move(verdict));
  instances_.push_back(object.instance);
}

std::vector<std::string> Referee::judge(Stamp now, std::span<const JudgedSegment> segments,
                                        const world::InstanceImage& instances,
                                        const std::vector<world::ObjectTruth>& objects) {
  std::vector<std::string> news;
  segments_ += static_cast<int>(segments.size());
  false_segments_ += static_cast<int>(std::count_if(
      segments.begin(), segments.end(), [&](const JudgedSegment& s) { return !shows_an_object(s, instances); }));
  for (std::size_t i = 0; i < verdicts_.size(); ++i) {
    ObjectVerdict& verdict = verdicts_[i];
    const auto truth = std::find_if(objects.begin(), objects.end(),
                                    [&](const world::ObjectTruth& o) { return o.instance == instances_[i]; });
    if (verdict.found || truth == objects.end()) continue;
    verdict.position_world = truth->bounds.center();
    const auto visible = std::count(instances.instances.begin(), instances.instances.end(), instances_[i]);
    for (const JudgedSegment& segment : segments) {
      const auto shared = std::count_if(segment.pixels.begin(), segment.pixels.end(), [&](std::uint32_t pixel) {
        return instances.instances[pixel] == instances_[i];
      });
      if (shared == 0) continue;
      const double cover = static_cast<double>(shared) / static_cast<double>(visible);
      const double purity = static_cast<double>(shared) / static_cast<double>(segment.pixels.size());
      if (!verdict.covered && cover > verdict.cover) {
        verdict.cover = cover;
        verdict.purity = purity;
      }
      if (cover < params_.min_cover || purity < params_.min_purity) continue;
      const double error = ((T_world_map_ * segment.centre).p - verdict.position_world).norm();
      if (verdict.covered && error >= verdict.error_m) continue;
      verdict.covered = true;
      verdict.cover = cover;
      verdict.purity = purity;
      verdict.error_m = error;
      verdict.found_position = segment.centre;
    }
    if (!verdict.covered || verdict.error_m > params_.max_error_m) continue;
    verdict.found = true;
    verdict.found_at_s = seconds(now);
    news.push_back(verdict.name);
  }
  return news;
}

bool Referee::shows_an_object(const JudgedSegment& segment, const world::InstanceImage& instances) const {
  return std::any_of(instances_.begin(), instances_.end(), [&](std::uint16_t instance) {
    const auto shared = std::count_if(segment.pixels.begin(), segment.pixels.end(),
                                      [&](std::uint32_t pixel) { return instances.instances[pixel] == instance; });
    return static_cast<double>(shared) >= params_.min_purity * static_cast<double>(segment.pixels.size());
  });
}

bool Referee::all_found() const { return found() == static_cast<int>(verdicts_.size()); }

int Referee::found() const {
  return static_cast<int>(std::count_if(verdicts_.begin(), verdicts_.end(), [](const auto& v) { return v.found; }));
}

bool Referee::is_false(const Point<Map>& centre, double radius_m,
                       const std::vector<world::ObjectTruth>& objects) const {
  const Eigen::Vector2d middle = (T_world_map_ * centre).p.head<2>();
  return std::none_of(objects.begin(), objects.end(), [&](const world::ObjectTruth& object) {
    const Eigen::AlignedBox2d footprint(Eigen::Vector2d(object.bounds.min().head<2>()),
                                        Eigen::Vector2d(object.bounds.max().head<2>()));
    return footprint.exteriorDistance(middle) <= radius_m + params_.region_margin_m;
  });
}

}  // namespace amiss::score
