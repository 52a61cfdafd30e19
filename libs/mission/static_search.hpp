// The static method of chapter 4, the baseline: drive to every view triangle and segment the whole frame there, as
// methods with fixed waypoints do. It neither compares with the reference nor leaves out a view triangle because its
// floor was seen on the way: a segmentation at each of them is all that it finds anything by (thesis 4.3).
// When all triangles of a set are used up, the next set covers the floor that was not segmented yet; when that is
// nothing worth a triangle, all floor is open again.
#pragma once

#include "mission/search_method.hpp"

namespace amiss::mission {

class StaticSearch : public SearchMethod {
 public:
  using SearchMethod::SearchMethod;

 private:
  std::vector<Visit> open_visits() override;
  bool add_view_triangles() override;
  Progress arrived(const Visit& visit) override;
  void mark_segmented(const view::ViewTriangle& view);

  FloorGrid segmented_floor_;
};

}  // namespace amiss::mission
