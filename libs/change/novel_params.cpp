#include "change/novel.hpp"

namespace amiss::change {

void describe(ParamTable& table, NovelParams& p) {
  describe(table, p.planes);
  table.number("detect.voxel", p.voxel_m, "m", 0.002, 0.05, "clouds are thinned to it");
  table.number("detect.cluster_distance", p.cluster_distance_m, "m", 0.002, 0.2,
               "proximity of points of one candidate (tau_segm)");
  table.number("detect.plane_alignment", p.plane_alignment_m, "m", 0.005, 0.5,
               "largest distance of plane-plane alignment (d_pp)");
  table.number("detect.object_alignment", p.object_alignment_m, "m", 0.01, 0.5,
               "largest distance of object-map alignment (d_om)");
  table.number("detect.reference_margin", p.reference_margin_m, "m", 0.01, 1.0,
               "crop of the reference round a candidate (c_ref): permanent things may move so far");
  table.number("detect.current_margin", p.current_margin_m, "m", 0.0, 0.5,
               "round a candidate (c_curr): what moved with it");
  table.number("detect.difference", p.difference_m, "m", 0.002, 0.2, "of Equation 5.1 (d)");
  table.number("detect.max_overlap", p.max_overlap, "1", 0.0, 1.0, "of a novel object with the reference (o_max)");
  table.number("detect.filter_distance", p.filter_distance_m, "m", 0.002, 0.2,
               "proximity of points of one object (tau_filter)");
  table.integer("detect.min_points", p.min_points, 1, 100000, "of an object (obj_min)");
  table.number("detect.max_size", p.max_size_m, "m", 0.05, 5.0, "of an object");
  table.number("detect.max_taken", p.max_taken, "1", 0.0, 1.0,
               "share of a fit's counterpart that may still stand where it was");
  table.number("detect.max_left_over", p.max_left_over, "1", 0.0, 1.0,
               "share of a fit's counterpart that may have moved into empty space");
  table.number("detect.max_colour_distance", p.max_colour_distance, "1", 0.0, 442.0,
               "of a fit, median, Euclidean in RGB of 0..255");
  table.number("detect.max_unseen", p.max_unseen, "1", 0.0, 1.0,
               "share of a candidate that may lie where the reference did not look");
  table.number("detect.min_depth", p.min_depth_m, "m", 0.0, 0.5,
               "upper quartile of the distances from the reference of a part of something that is at rest");
  table.number("detect.continuation", p.continuation_m, "m", 0.0, 0.5,
               "how far a surface of the reference may go on where the reference saw no empty space");
  table.number("detect.max_continued", p.max_continued, "1", 0.0, 1.0,
               "share of a part that may be such a continuation");
  table.number("detect.nudge", p.nudge_m, "m", 0.0, 0.2,
               "how far furniture is nudged: what is so near beside the reference, at its height, is its edge");
  table.number("detect.max_nudged", p.max_nudged, "1", 0.0, 1.0, "share of a part that may be such an edge");
  table.number("detect.recolour", p.recolour, "1", 0.0, 442.0,
               "Euclidean in RGB of 0..255, by which a flat thing differs from what it lies on");
  table.number("detect.recolour_reach", p.recolour_reach_m, "m", 0.0, 0.5,
               "and from everything of the reference that is so near, at its height");
}

std::string_view name_of(Verdict verdict) {
  switch (verdict) {
    case Verdict::kNovel:
      return "novel";
    case Verdict::kAtRest:
      return "at rest";
    case Verdict::kMovedALittle:
      return "moved a little";
    case Verdict::kUnseen:
      return "reference did not look";
    case Verdict::kShallow:
      return "too near to the reference";
    case Verdict::kContinued:
      return "continues a surface";
    case Verdict::kNudged:
      return "edge of something nudged";
    case Verdict::kTooSmall:
      return "too small";
    case Verdict::kTooLarge:
      return "too large";
    case Verdict::kNotVerified:
      return "not verified";
  }
  return "?";
}

}  // namespace amiss::change
