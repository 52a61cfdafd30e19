// What the robot knows about its environment: regions of interest (Section 4.2.5), view triangles and objects found.
// now() is a value in memory, cheap to query and to copy; the SQLite file (through SOCI) is its record, written through
// in one transaction for each change. All positions in the map frame [m], stamps of the run's clock.
// A path that does not exist is created; a file that is no knowledge base of this program, is broken or cannot be
// written is an InputError.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "core/frames.hpp"
#include "core/params.hpp"
#include "core/stamp.hpp"

namespace amiss::knowledge {

struct Params {
  double same_overlap = 0.85;      // part of the smaller circle that two circles of one region share
  double same_distance = 1.0;      // in larger radii: centres that are nearer are of one region
  double noticeable_growth = 0.3;  // part by which the circle's area or the height grows,
  double noticeable_m = 0.1;       // and length by which radius or height grows, before it is examined again
};
void describe(ParamTable& table, Params& p);

/// Upright bounding cylinder in the map frame.
struct Cylinder {
  Eigen::Vector2d centre_map = Eigen::Vector2d::Zero();
  double radius_m = 0.0;
  double z_low_m = 0.0;
  double z_high_m = 0.0;
  bool operator==(const Cylinder&) const = default;
};

/// A region as differencing sees it now.
struct Sighting {
  Eigen::Vector3d position_map = Eigen::Vector3d::Zero();  // centre of its extent
  Cylinder cylinder;
  int voxels = 0;
};

/// A region as it is remembered.
struct Region {
  int id = 0;  // from 1, never used twice
  Eigen::Vector3d position_map = Eigen::Vector3d::Zero();
  Cylinder cylinder;
  int voxels = 0;
  Stamp first_seen, last_seen;
  bool examined = false;
  bool withdrawn = false;
  std::optional<Stamp> examined_at;
  Cylinder examined_cylinder;  // as it was then
  bool operator==(const Region&) const = default;
};

enum class Change {
  kInserted,   // new
  kGrown,      // larger than it was remembered; stays examined where it was
  kReopened,   // grew noticeably since it was examined: to be examined again
  kReturned,   // was withdrawn and is there again; to be examined unless it was
  kWithdrawn,  // looked at again and not confirmed
  kAbsorbed    // turned out to be a part of another region, and is withdrawn
};
struct RegionChange {
  int region = 0;  // id
  Change change = Change::kInserted;
  bool operator==(const RegionChange&) const = default;
};

/// A view triangle of Section 4.2.2: apex, direction of view and size.
struct View {
  int id = 0;  // from 1
  Pose2<Map, Base> T_map_base;
  double angle_rad = 0.0;  // tr_angle
  double height_m = 0.0;   // tr_height
  bool dropped = false;    // covered before it was visited
  std::optional<Stamp> visited_at;
};

/// A segment of an examination.
struct Object {
  int id = 0;      // from 1
  int region = 0;  // id of the region examined, 0 when the whole frame was segmented
  Stamp seen_at;
  Eigen::Vector3d centre_map = Eigen::Vector3d::Zero();
  Eigen::Vector3d size_m = Eigen::Vector3d::Zero();
  int points = 0;
  bool operator==(const Object&) const = default;
};

/// Everything known; ids are positions in the vectors plus one.
struct Knowledge {
  std::vector<Region> regions;
  std::vector<View> views;
  std::vector<Object> objects;
};

class KnowledgeBase {
 public:
  KnowledgeBase(const std::filesystem::path& file, const Params& params);
  explicit KnowledgeBase(const Params& params);  // in memory only, without a record
  ~KnowledgeBase();
  KnowledgeBase(KnowledgeBase&&) noexcept;
  KnowledgeBase& operator=(KnowledgeBase&&) noexcept;

  [[nodiscard]] const Knowledge& now() const;
  /// Neither examined nor withdrawn, in the order of first_seen.
  [[nodiscard]] std::vector<Region> open_regions() const;

  /// All regions that differencing sees at `stamp`. Regions that are stored, not among them and for which
  /// `looked_again` holds are withdrawn; the others stay as they are. Changes in the order of region ids.
  std::vector<RegionChange> merge(const std::vector<Sighting>& seen_now,
                                  const std::function<bool(const Region&)>& looked_again, Stamp stamp);

  void mark_examined(int region_id, Stamp stamp);
  /// Returns the ids of the views, in their order. The ids in `views` are not read.
  std::vector<int> add_views(const std::vector<View>& views);
  void mark_visited(int view_id, Stamp stamp);
  void mark_dropped(int view_id);
  int add_object(const Object& object);  // its id is not read; returns the new one

  /// Closes the file; later changes stay in memory. The destructor closes too. Every change throws std::runtime_error
  /// where the file cannot be written (disk full).
  void close();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace amiss::knowledge
