#include "core/frames.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <type_traits>

namespace amiss {
namespace {

constexpr double kPi = std::numbers::pi;

double between(double low, double high) { return *rc::gen::inRange(0, 1000001) * 1e-6 * (high - low) + low; }

template <class To, class From>
Pose2<To, From> any_pose() {
  return {between(-50.0, 50.0), between(-50.0, 50.0), between(-3.1, 3.1)};
}

TEST(Frames, WrapAngleKeepsPiAndTurnsMinusPi) {
  EXPECT_DOUBLE_EQ(wrap_angle(kPi), kPi);
  EXPECT_DOUBLE_EQ(wrap_angle(-kPi), kPi);
  EXPECT_DOUBLE_EQ(wrap_angle(0.0), 0.0);
  EXPECT_NEAR(wrap_angle(3.0 * kPi), kPi, 1e-12);
  EXPECT_NEAR(wrap_angle(-2.5 * kPi), -0.5 * kPi, 1e-12);
}

RC_GTEST_PROP(Frames, WrappedAnglePointsWhereItDid, ()) {
  const double angle = between(-100.0, 100.0);
  const double wrapped = wrap_angle(angle);
  RC_ASSERT(wrapped > -kPi && wrapped <= kPi);
  RC_ASSERT(std::abs(std::sin(wrapped) - std::sin(angle)) < 1e-9);
  RC_ASSERT(std::abs(std::cos(wrapped) - std::cos(angle)) < 1e-9);
}

TEST(Frames, DegreesAndRadians) {
  EXPECT_DOUBLE_EQ(radians(180.0), kPi);
  EXPECT_DOUBLE_EQ(degrees(radians(58.0)), 58.0);
}

RC_GTEST_PROP(Frames, PlanarPosesComposeAsTheirLiftedTransforms, ()) {
  const auto T_map_odom = any_pose<Map, Odom>();
  const auto T_odom_base = any_pose<Odom, Base>();
  const Pose2<Map, Base> planar = T_map_odom * T_odom_base;
  static_assert(std::is_same_v<decltype(T_map_odom.lift() * T_odom_base.lift()), Transform<Map, Base>>);
  RC_ASSERT(planar.lift().T.isApprox((T_map_odom.lift() * T_odom_base.lift()).T, 1e-9));
}

RC_GTEST_PROP(Frames, InverseUndoes, ()) {
  const auto T_map_base = any_pose<Map, Base>();
  const Pose2<Base, Base> none = T_map_base.inverse() * T_map_base;
  RC_ASSERT(none.position().norm() < 1e-9);
  RC_ASSERT(std::abs(none.yaw_rad) < 1e-9);
  const Transform<Base, Base> lifted = T_map_base.lift().inverse() * T_map_base.lift();
  RC_ASSERT(lifted.T.isApprox(Eigen::Isometry3d::Identity(), 1e-9));
}

TEST(Frames, PointsAreCarriedIntoTheOtherFrame) {
  const Pose2<Map, Base> T_map_base{1.0, 2.0, 0.5 * kPi};  // looks along y of the map
  const Point<Map> ahead = T_map_base.lift() * Point<Base>{{3.0, 0.0, 0.7}};
  EXPECT_TRUE(ahead.p.isApprox(Eigen::Vector3d(1.0, 5.0, 0.7)));
}

}  // namespace
}  // namespace amiss
