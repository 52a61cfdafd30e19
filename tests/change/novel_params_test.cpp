#include <gtest/gtest.h>

#include <set>

#include "change/novel.hpp"
#include "core/result.hpp"

namespace amiss::change {
namespace {

TEST(NovelParams, DefaultsAreThoseOfTable51) {
  const NovelParams p;
  EXPECT_EQ(p.cluster_distance_m, 0.015);
  EXPECT_EQ(p.plane_alignment_m, 0.05);
  EXPECT_EQ(p.object_alignment_m, 0.15);
  EXPECT_EQ(p.reference_margin_m, 0.2);
  EXPECT_EQ(p.current_margin_m, 0.05);
  EXPECT_EQ(p.difference_m, 0.014);
  EXPECT_EQ(p.max_overlap, 0.7);
  EXPECT_EQ(p.filter_distance_m, 0.02);
  EXPECT_EQ(p.min_points, 15);
}

TEST(NovelParams, AreReadByTheirNames) {
  NovelParams p;
  ParamTable table;
  describe(table, p);
  table.set("detect.difference", "0.007", "test");
  table.set("planes.distance", "0.02", "test");
  EXPECT_EQ(p.difference_m, 0.007);
  EXPECT_EQ(p.planes.distance_m, 0.02);
  EXPECT_THROW(table.set("detect.max_overlap", "1.5", "test"), ArgumentError);
}

TEST(NovelParams, VerdictsHaveNames) {
  std::set<std::string_view> names;
  for (int v = 0; v <= static_cast<int>(Verdict::kNotVerified); ++v) names.insert(name_of(static_cast<Verdict>(v)));
  EXPECT_EQ(names.size(), static_cast<std::size_t>(Verdict::kNotVerified) + 1);
  EXPECT_FALSE(names.contains("?"));
}

}  // namespace
}  // namespace amiss::change
