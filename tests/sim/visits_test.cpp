#include "sim/visits.hpp"

#include <gtest/gtest.h>

#include <map>
#include <set>

#include "core/result.hpp"
#include "sim/furnished.hpp"

namespace amiss::sim {
namespace {

class VisitsTest : public ::testing::Test {
 protected:
  [[nodiscard]] std::vector<Visit> visits(const std::vector<int>& counts, std::uint64_t seed) const {
    const VisitedRoom room{world_, classes_, catalogue_, model_, {2.0, 2.0, 0.0}, {}};
    return make_visits(room, counts, {}, RandomStream(seed, "test/visits"));
  }
  static std::map<std::string, Eigen::Vector3d> places(const Visit& visit) {
    std::map<std::string, Eigen::Vector3d> found;
    for (const ScatteredObject& object : visit.objects) found[object.kind] = object.pose.position();
    return found;
  }

  world::World world_ = test::furnished_room();
  world::ClassTable classes_ = test::classes();
  world::Catalogue catalogue_ = test::toys();
  robot::Model model_ = test::small_robot();
};

TEST_F(VisitsTest, BetweenVisitsObjectsStayMoveGoAndCome) {
  const std::vector<int> counts{5, 4, 5, 3, 5};
  const auto made = visits(counts, 3);
  ASSERT_EQ(made.size(), counts.size());
  int stayed = 0, moved = 0, gone = 0, came = 0, nudged = 0;
  for (std::size_t k = 0; k < made.size(); ++k) {
    const auto now = places(made[k]);
    EXPECT_EQ(now.size(), static_cast<std::size_t>(counts[k]));  // each kind once
    EXPECT_EQ(made[k].objects.size(), now.size());
    nudged += static_cast<int>(made[k].nudges.size());
    if (k == 0) continue;
    const auto before = places(made[k - 1]);
    for (const auto& [kind, p] : now) {
      const auto was = before.find(kind);
      if (was == before.end()) ++came;
      else ((was->second - p).norm() < 0.1 ? stayed : moved) += 1;
    }
    for (const auto& [kind, p] : before) gone += now.contains(kind) ? 0 : 1;
  }
  EXPECT_GT(stayed, 0);
  EXPECT_GT(moved, 0);
  EXPECT_GT(gone, 0);
  EXPECT_GT(came, 0);
  EXPECT_GT(nudged, 0);
}

TEST_F(VisitsTest, ASeedMeansTheSameVisits) {
  const auto a = visits({4, 5}, 11), b = visits({4, 5}, 11), c = visits({4, 5}, 12);
  bool differs = false;
  for (std::size_t k = 0; k < a.size(); ++k) {
    ASSERT_EQ(a[k].objects.size(), b[k].objects.size());
    ASSERT_EQ(a[k].nudges.size(), b[k].nudges.size());
    for (std::size_t i = 0; i < a[k].objects.size(); ++i) {
      EXPECT_EQ(a[k].objects[i].name, b[k].objects[i].name);
      EXPECT_EQ(a[k].objects[i].pose.T.matrix(), b[k].objects[i].pose.T.matrix());
      differs |= i >= c[k].objects.size() || a[k].objects[i].name != c[k].objects[i].name;
    }
  }
  EXPECT_TRUE(differs);
}

TEST_F(VisitsTest, NoObjectsAreNoVisitGoneWrong) {
  EXPECT_TRUE(visits({0}, 1)[0].objects.empty());
  EXPECT_THROW(static_cast<void>(visits({-1}, 1)), ArgumentError);
}

}  // namespace
}  // namespace amiss::sim
