// Novel objects in a room: what is there now and was not in the reference, and did not merely move a little (Section
// 5.2, Table 5.1).
// in: two scenes in one map frame [m], the method by name. out: objects with their points, and every decision with the
// numbers behind it; indices are those of the current cloud, objects largest first.
// Errors: ArgumentError for a name that is no method, labels whose number is not that of the points, or an empty cloud.
// Repeatable: random streams have fixed seeds.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/frames.hpp"
#include "core/params.hpp"
#include "mapping/voxel_map.hpp"
#include "segment/support_planes.hpp"

namespace amiss::change {

/// A room as it was reconstructed.
struct Scene {
  Cloud<Map> cloud;                        // points [m], colours (or none); normals are not used
  std::vector<SemanticClass> labels;       // of NYU40, one for each point, or none
  std::optional<mapping::VoxelMap> space;  // where was looked: free, occupied; without it all counts as seen
};

struct NovelParams {
  segment::SupportPlaneParams planes;
  double voxel_m = 0.01;              // clouds are thinned to it
  double cluster_distance_m = 0.015;  // tau_segm
  double plane_alignment_m = 0.05;    // d_pp
  double object_alignment_m = 0.15;   // d_om
  double reference_margin_m = 0.2;    // c_ref
  double current_margin_m = 0.05;     // c_curr
  double difference_m = 0.014;        // d of Equation 5.1
  double max_overlap = 0.7;           // o_max
  double filter_distance_m = 0.02;    // tau_filter
  int min_points = 15;                // obj_min
  double max_size_m = 1.0;            // of an object
  double max_taken = 0.5;             // of a fit's counterpart that is still where it was
  double max_left_over = 0.5;         // of a fit's counterpart that would have moved into empty space
  double max_colour_distance = 90.0;  // of a fit, median, Euclidean in RGB of 0..255
  double max_unseen = 0.7;            // of a candidate where the reference did not look
  double min_depth_m = 0.018;         // by which a part of something at rest differs from the reference
  double continuation_m = 0.1;        // how far a surface of the reference may be continued where it was not seen
  double max_continued = 0.4;         // of a part that continues a surface
  double nudge_m = 0.045;             // beside an edge of the reference
  double max_nudged = 0.4;            // of a part that stands so near beside an edge
  double recolour = 60.0;             // Euclidean in RGB of 0..255, by which a flat thing differs from what it lies on
  double recolour_reach_m = 0.1;      // and from all of the reference that is so near
};
void describe(ParamTable& table, NovelParams& p);

enum class Verdict {
  kNovel,
  kAtRest,
  kMovedALittle,
  kUnseen,
  kShallow,
  kContinued,
  kNudged,
  kTooSmall,
  kTooLarge,
  kNotVerified
};
[[nodiscard]] std::string_view name_of(Verdict verdict);

/// What was decided about one candidate, and why.
struct Decision {
  std::string source;                 // "plane", "otherprop", "colour"
  std::optional<std::size_t> object;  // of Detection::objects, that it became or became a part of
  std::uint32_t point = 0;            // one of its points, of the thinned cloud
  Verdict verdict = Verdict::kNovel;
  int points = 0;                                                                     // of the thinned cloud
  SemanticClass label = SemanticClass::kUnlabelled;                                   // of most of its points
  Eigen::Vector3d low_m = Eigen::Vector3d::Zero(), high_m = Eigen::Vector3d::Zero();  // bounds in the map
  double support_height_m = 0.0;                                                      // of the plane under it
  double overlap_at_rest = 0.0;            // share of its cluster within d of the reference
  double overlap_moved = 0.0;              // the same after the best fit
  double moved_m = 0.0, turned_rad = 0.0;  // that fit
  double taken = 0.0, left_over = 0.0, colour_distance = 0.0, unseen = 0.0, depth_m = 0.0, continued = 0.0,
         nudged = 0.0;  // beside the limits in NovelParams
};

struct NovelObject {
  segment::Indices points;  // of the current cloud, ascending
  Eigen::Vector3d low_m = Eigen::Vector3d::Zero(), high_m = Eigen::Vector3d::Zero();
};

struct Detection {
  std::vector<NovelObject> objects;
  std::vector<Decision> decisions;                    // as they were made; none of the methods without verification
  int planes = 0;                                     // support surfaces
  Eigen::Vector3d shift_m = Eigen::Vector3d::Zero();  // of the current room onto the reference
  double turn_rad = 0.0;
};

/// "local-verification", "no-planes", "no-verification", "semantic", "octomap", "metaroom".
[[nodiscard]] const std::vector<std::string>& detection_methods();

/// Lays the rooms on one another once and then detects by one method after another.
class NovelDetector {
 public:
  /// Both scenes must outlive it.
  NovelDetector(const Scene& reference, const Scene& current, const NovelParams& params = {});
  ~NovelDetector();
  NovelDetector(const NovelDetector&) = delete;
  NovelDetector& operator=(const NovelDetector&) = delete;

  [[nodiscard]] Detection detect(const std::string& method) const;

 private:
  struct Rooms;
  std::unique_ptr<Rooms> rooms_;
};

[[nodiscard]] Detection detect_novel(const Scene& reference, const Scene& current, const std::string& method,
                                     const NovelParams& params = {});

}  // namespace amiss::change
