#include "mission/odometer.hpp"

#include <algorithm>
#include <cmath>

namespace amiss::mission {

namespace {

constexpr Duration kRemembered = std::chrono::seconds(10);
constexpr double kLeapFactor = 4.0;  // times the robot's speed limits: no base moves so
constexpr double kLeapM = 0.3, kLeapRad = 0.6;
constexpr double kUnfeltM = 0.06, kUnfeltRad = 0.06;  // motion that the laser shows and odometry does not
constexpr double kEnoughM = 1.0, kEnoughRad = 2.0;    // of motion, for a factor
constexpr double kWrongBy = 0.12;                     // of a factor
constexpr double kLeastM = 0.015, kLeastRad = 0.03;   // between two scans, that a factor is measured by
constexpr double kMostM = 0.3, kMostRad = 0.5;        // beyond, the laser found itself elsewhere

Pose2<Base, Base> scaled(const Pose2<Base, Base>& motion, double length_factor, double turn_factor) {
  return {motion.x_m / length_factor, motion.y_m / length_factor, motion.yaw_rad / turn_factor};
}

bool is_finite(const Pose2<Odom, Base>& p) {
  return std::isfinite(p.x_m) && std::isfinite(p.y_m) && std::isfinite(p.yaw_rad);
}

bool is_equal(const Pose2<Odom, Base>& a, const Pose2<Odom, Base>& b) {
  return a.x_m == b.x_m && a.y_m == b.y_m && a.yaw_rad == b.yaw_rad;
}

const Odometry& nearest(const std::deque<Odometry>& history, Stamp stamp) {
  const auto after =
      std::lower_bound(history.begin(), history.end(), stamp, [](const Odometry& o, Stamp s) { return o.stamp < s; });
  return after == history.end() ? history.back() : *after;
}

void remember(std::deque<Odometry>& history, Stamp now, const Pose2<Odom, Base>& pose) {
  history.push_back({now, pose});
  while (history.front().stamp + kRemembered < now) history.pop_front();
}

}  // namespace

void Odometer::Regression::add(double told, double seen) {
  squares += seen * seen;
  products += told * seen;
  sum += std::abs(seen);
}

std::optional<double> Odometer::Regression::factor(double enough) const {
  if (sum < enough || squares <= 0.0) return std::nullopt;
  return products / squares;
}

bool Odometer::is_credible(const Odometry& told) const {
  if (!last_told_) return true;
  const double dt_s = std::max(0.0, seconds(told.stamp - last_told_->stamp));
  const Pose2<Base, Base> moved = last_told_->T_odom_base.inverse() * told.T_odom_base;
  return moved.position().norm() < kLeapM + kLeapFactor * limits_.speed_m_s * dt_s &&
         std::abs(moved.yaw_rad) < kLeapRad + kLeapFactor * limits_.yaw_rate_rad_s * dt_s;
}

void Odometer::drive(const robot::Command& command, double dt_s) {
  const Eigen::Vector2d wanted = command.velocity_base_m_s - velocity_base_m_s_;
  const double most = limits_.acceleration_m_s2 * dt_s;
  velocity_base_m_s_ += wanted.norm() > most ? Eigen::Vector2d(most * wanted.normalized()) : wanted;
  const double most_yaw = limits_.yaw_acceleration_rad_s2 * dt_s;
  yaw_rate_rad_s_ += std::clamp(command.yaw_rate_rad_s - yaw_rate_rad_s_, -most_yaw, most_yaw);
  commanded_ = commanded_ *
               Pose2<Base, Base>{velocity_base_m_s_.x() * dt_s, velocity_base_m_s_.y() * dt_s, yaw_rate_rad_s_ * dt_s};
}

Pose2<Base, Base> Odometer::commanded_since(Stamp stamp) const {
  return nearest(commanded_history_, stamp).T_odom_base.inverse() * commanded_;
}

/// A told pose that is news.
void Odometer::believe(const Odometry& told) {
  if (told_ && !is_equal(told.T_odom_base, told_->T_odom_base)) {
    changed_ = true;
    by_commands_ = false;
  }
  if (plain_ || !told_) {
    believed_at_told_ = told.T_odom_base;
  } else if (by_commands_) {
    believed_at_told_ = believed_at_told_ * (nearest(commanded_history_, told_->stamp).T_odom_base.inverse() *
                                             nearest(commanded_history_, told.stamp).T_odom_base);
  } else {
    const Pose2<Base, Base> motion = told_->T_odom_base.inverse() * told.T_odom_base;
    believed_at_told_ = believed_at_told_ * scaled(motion, length_factor_, turn_factor_);
  }
  told_ = told;
}

void Odometer::update(const Odometry& told, Stamp now, const robot::Command& command) {
  const double dt_s = commanded_history_.empty() ? 0.0 : seconds(now - commanded_history_.back().stamp);
  drive(command, dt_s);
  remember(commanded_history_, now, commanded_);
  garbage_ = !is_finite(told.T_odom_base);
  if (!garbage_) {
    const bool is_news = !told_ || told.stamp > told_->stamp;
    if (is_news && is_credible(told)) believe(told);
    last_told_ = told;
  }
  Pose2<Odom, Base> pose = believed_at_told_;
  if (!told_ || told_->stamp < now) pose = pose * commanded_since(told_ ? told_->stamp : Stamp{});
  remember(history_, now, pose);
}

void Odometer::compare(const Pose2<Map, Base>& T_map_base, bool believed) {
  if (!believed) {
    compared_at_.reset();
    return;
  }
  if (changed_ || !unchanged_from_) {
    unchanged_from_ = T_map_base;
    changed_ = false;
  }
  const Pose2<Base, Base> unfelt = unchanged_from_->inverse() * T_map_base;
  const bool is_moving = velocity_base_m_s_.norm() > 0.01 || std::abs(yaw_rate_rad_s_) > 0.02;
  const bool is_unfelt = unfelt.position().norm() > kUnfeltM || std::abs(unfelt.yaw_rad) > kUnfeltRad;
  if (is_unfelt && is_moving && !by_commands_) {
    by_commands_ = true;
    plain_ = false;
  }
  if (compared_at_ && !by_commands_) {
    watch_factors(compared_at_->inverse() * pose(), compared_map_.inverse() * T_map_base);
  }
  compared_at_ = pose();
  compared_map_ = T_map_base;
}

void Odometer::watch_factors(const Pose2<Base, Base>& told, const Pose2<Base, Base>& seen) {
  const double seen_m = seen.position().norm();
  if (seen_m > kMostM || std::abs(seen.yaw_rad) > kMostRad) return;
  if (seen_m > kLeastM) lengths_.add(told.position().dot(seen.position()) / seen_m, seen_m);
  if (std::abs(seen.yaw_rad) > kLeastRad) turns_.add(told.yaw_rad, seen.yaw_rad);
  const auto learn = [&](Regression& regression, double enough, double& factor) {
    const auto measured = regression.factor(enough);
    if (!measured) return;
    if (std::abs(*measured - 1.0) > kWrongBy && *measured > 0.2) {
      factor *= *measured;
      plain_ = false;
    }
    regression = {};
  };
  learn(lengths_, kEnoughM, length_factor_);
  learn(turns_, kEnoughRad, turn_factor_);
}

Pose2<Odom, Base> Odometer::at(Stamp stamp) const { return nearest(history_, stamp).T_odom_base; }

Pose2<Odom, Base> Odometer::at(Stamp stamp, const Pose2<Odom, Base>& told) const {
  return plain_ && is_finite(told) ? told : at(stamp);
}

std::optional<Trouble> Odometer::trouble(Stamp now) const {
  const Stamp heard = told_ ? told_->stamp : Stamp{};
  if (now - heard <= duration_of(params_.silent_s)) return std::nullopt;
  return Trouble{Sense::kOdometry, garbage_ ? Complaint::kGarbage : Complaint::kSilent, heard};
}

}  // namespace amiss::mission
