#include "report/trajectory.hpp"

#include <gtest/gtest.h>

#include <sstream>

namespace amiss::report {
namespace {

TEST(TumTrajectory, LinesReadBack) {
  TumTrajectory trajectory;
  trajectory.add(Stamp(duration_of(0.02)), 1.25, -3.5, radians(90.0));
  trajectory.add(Stamp(duration_of(3599.98)), -1e-7, 1e4, radians(-179.0));
  std::istringstream text(trajectory.text());
  std::string comment;
  std::getline(text, comment);
  EXPECT_EQ(comment.front(), '#');
  double t = 0.0, x = 0.0, y = 0.0, z = 1.0, qx = 1.0, qy = 1.0, qz = 0.0, qw = 0.0;
  text >> t >> x >> y >> z >> qx >> qy >> qz >> qw;
  EXPECT_DOUBLE_EQ(t, 0.02);
  EXPECT_DOUBLE_EQ(x, 1.25);
  EXPECT_DOUBLE_EQ(y, -3.5);
  EXPECT_EQ(z, 0.0);
  EXPECT_NEAR(2.0 * std::atan2(qz, qw), radians(90.0), 1e-8);
  text >> t >> x >> y >> z >> qx >> qy >> qz >> qw;
  EXPECT_DOUBLE_EQ(t, 3599.98);
  EXPECT_NEAR(qz * qz + qw * qw, 1.0, 1e-8);
  EXPECT_TRUE(text.good());
}

}  // namespace
}  // namespace amiss::report
