#include "localize/localizer.hpp"

#include <mrpt/bayes/CParticleFilter.h>
#include <mrpt/obs/CActionCollection.h>
#include <mrpt/obs/CActionRobotMovement2D.h>
#include <mrpt/obs/CSensoryFrame.h>
#include <mrpt/random/RandomGenerators.h>
#include <mrpt/slam/CMonteCarloLocalization2D.h>

#include <algorithm>

#include "core/result.hpp"
#include "localize/internal/distance_field.hpp"
#include "localize/internal/global_search.hpp"
#include "localize/internal/mrpt_types.hpp"

namespace amiss::localize {

namespace {

constexpr double kMinMotionXyM = 0.004;  // noise of the motion model at rest keeps particles apart
constexpr double kMinMotionYawRad = radians(0.15);
constexpr double kTempering = 0.25;  // exponent of the likelihood: beams are not independent
constexpr int kRefineBeams = 240;
constexpr double kPriorSigmaXyM = 0.06;  // least deviation that the filter is trusted with
constexpr double kPriorSigmaYawRad = radians(2.0);
constexpr double kCorrectionGain = 0.5;   // part of a correction that a scan applies,
constexpr double kFullCorrectionM = 0.1;  // all of it where the robot drove or turned so far since the last one
constexpr double kFullCorrectionRad = 0.2;
constexpr double kJumpM = 0.2;  // corrections beyond are applied at once
constexpr int kLostScans = 10;  // that do not fit in a row, then the particles spread
constexpr int kMaxSpreads = 5;
constexpr double kLostSpreadM = 0.3;
constexpr int kFirstDoubt = 4;        // doubtful scans in a row, then the whole map is searched,
constexpr int kNextDoubt = 10;        // and again after so many
constexpr double kMuchBetter = 0.15;  // in plausibility, than where the robot believes to be
constexpr double kUnlike = 0.08;      // in plausibility, the next best place
constexpr StartSpread kFoundSpread{0.08, radians(3.0)};

mrpt::slam::CMonteCarloLocalization2D make_filter(const FloorGrid& map, const LocalizerParams& params) {
  mrpt::maps::COccupancyGridMap2D::Ptr grid = internal::to_mrpt(map);
  auto& likelihood = grid->likelihoodOptions;
  likelihood.likelihoodMethod = mrpt::maps::COccupancyGridMap2D::lmLikelihoodField_Thrun;
  likelihood.LF_stdHit = static_cast<float>(params.hit_sigma_m);
  likelihood.LF_zHit = static_cast<float>(params.hit_weight);
  likelihood.LF_zRandom = static_cast<float>(1.0 - params.hit_weight);
  likelihood.LF_maxRange = 20.0F;
  likelihood.LF_maxCorrsDistance = static_cast<float>(4.0 * params.hit_sigma_m);
  likelihood.LF_decimation = 1;
  likelihood.enableLikelihoodCache = true;
  mrpt::slam::CMonteCarloLocalization2D filter(static_cast<std::size_t>(params.particles));
  filter.options.metricMap = grid;
  return filter;
}

mrpt::obs::CActionCollection action_of(const Pose2<Base, Base>& moved, const LocalizerParams& params) {
  mrpt::obs::CActionRobotMovement2D::TMotionModelOptions options;
  options.modelSelection = mrpt::obs::CActionRobotMovement2D::mmGaussian;
  options.gaussianModel = {params.odometry_xy_per_m,    0.01,          params.odometry_yaw_per_m_rad,
                           params.odometry_yaw_per_rad, kMinMotionXyM, kMinMotionYawRad};
  mrpt::obs::CActionRobotMovement2D movement;
  movement.computeFromOdometry(internal::to_mrpt(moved), options);
  mrpt::obs::CActionCollection actions;
  actions.insert(movement);
  return actions;
}

mrpt::bayes::CParticleFilter make_sampler() {
  mrpt::bayes::CParticleFilter sampler;
  sampler.m_options.PF_algorithm = mrpt::bayes::CParticleFilter::pfStandardProposal;
  sampler.m_options.resamplingMethod = mrpt::bayes::CParticleFilter::prSystematic;
  sampler.m_options.BETA = 0.5;
  sampler.m_options.powFactor = kTempering;
  return sampler;
}

}  // namespace

struct Localizer::State {
  State(const FloorGrid& map, const LocalizerParams& p, RandomStream stream)
      : params(p),
        random(std::move(stream)),
        field(map),
        places(p.relocalize ? internal::places_to_stand(map, field) : std::vector<Eigen::Vector2d>{}),
        grid_origin_map(map.origin_m()),
        filter(make_filter(map, p)),
        sampler(make_sampler()) {}

  LocalizerParams params;
  RandomStream random;
  internal::DistanceField field;
  std::vector<Eigen::Vector2d> places;  // where a robot that was carried away may stand
  Eigen::Vector2d grid_origin_map;      // of the filter's frame
  mrpt::slam::CMonteCarloLocalization2D filter;
  mrpt::bayes::CParticleFilter sampler;

  Pose2<Map, Base> start;
  bool started = false;
  Pose2<Odom, Base> T_odom_base_filter;  // odometry that the particles stand at
  Pose2<Map, Odom> T_map_odom;
  PoseEstimate estimate;
  LocalizationEvidence evidence;
  int misfits = 0, spreads = 0;
  int doubts = 0;        // scans in a row that fit less than for sure
  bool checked = false;  // since these began, and no other place fits better

  void spread(const Pose2<Map, Base>& around, const StartSpread& deviations);
  Pose2<Map, Base> filtered(const Odometry& odometry, const LaserScan& scan,
                            const Transform<Base, Laser>& T_base_laser);
  void correct(const Odometry& odometry, const LaserScan& scan, const Transform<Base, Laser>& T_base_laser);
  void watch(const Pose2<Map, Base>& pose);
  void doubt(const Odometry& odometry, const std::vector<Eigen::Vector2d>& points_base,
             const Eigen::Vector2d& laser_base, const Pose2<Map, Base>& pose);
  void stand_at(const Pose2<Map, Base>& pose, const Odometry& odometry);
};

void Localizer::State::spread(const Pose2<Map, Base>& around, const StartSpread& deviations) {
  for (auto& particle : filter.m_particles) {
    particle.d.x = around.x_m - grid_origin_map.x() + deviations.xy_m * random.normal();
    particle.d.y = around.y_m - grid_origin_map.y() + deviations.xy_m * random.normal();
    particle.d.phi = wrap_angle(around.yaw_rad + deviations.yaw_rad * random.normal());
    particle.log_w = 0.0;
  }
}

/// One step of the particle filter; the mean of the particles.
Pose2<Map, Base> Localizer::State::filtered(const Odometry& odometry, const LaserScan& scan,
                                            const Transform<Base, Laser>& T_base_laser) {
  // A fresh generator, because seeding alone keeps the spare number of MRPT's normal distribution.
  mrpt::random::getRandomGenerator() = mrpt::random::CRandomGenerator(static_cast<std::uint32_t>(random.next() >> 32U));
  const auto actions = action_of(T_odom_base_filter.inverse() * odometry.T_odom_base, params);
  mrpt::obs::CSensoryFrame frame;
  frame.insert(internal::to_mrpt(scan, T_base_laser, params.beams));
  mrpt::bayes::CParticleFilter::TParticleFilterStats stats;
  sampler.executeOn(filter, &actions, &frame, &stats);
  T_odom_base_filter = odometry.T_odom_base;

  const auto [covariance, mean] = filter.getCovarianceAndMean();
  for (int row = 0; row < 3; ++row) {
    for (int col = 0; col < 3; ++col) estimate.covariance(row, col) = covariance(row, col);
  }
  evidence.effective_part = stats.ESS_beforeResample;
  evidence.spread_m = std::sqrt(std::max(0.0, covariance(0, 0) + covariance(1, 1)));
  return {mean.x() + grid_origin_map.x(), mean.y() + grid_origin_map.y(), wrap_angle(mean.phi())};
}

void Localizer::State::correct(const Odometry& odometry, const LaserScan& scan,
                               const Transform<Base, Laser>& T_base_laser) {
  const Pose2<Base, Base> moved = T_odom_base_filter.inverse() * odometry.T_odom_base;
  Pose2<Map, Base> pose = filtered(odometry, scan, T_base_laser);
  const auto points_base = internal::points_of(scan, T_base_laser, kRefineBeams);
  if (params.refine) {
    const double sigma_yaw_rad = std::sqrt(std::max(0.0, estimate.covariance(2, 2)));
    pose = internal::aligned(
        field, points_base,
        {pose, std::max(kPriorSigmaXyM, evidence.spread_m), std::max(kPriorSigmaYawRad, sigma_yaw_rad)});
  }
  evidence.fit = internal::fit_of(field, points_base, pose, params.fit_distance_m);
  ++evidence.scans;

  const Pose2<Map, Base> predicted = T_map_odom * odometry.T_odom_base;
  evidence.correction_m = (pose.position() - predicted.position()).norm();
  evidence.correction_rad = std::abs(wrap_angle(pose.yaw_rad - predicted.yaw_rad));
  const bool jump = evidence.correction_m > kJumpM;
  const double far = std::max(moved.position().norm() / kFullCorrectionM, std::abs(moved.yaw_rad) / kFullCorrectionRad);
  const double gain = jump || evidence.scans == 1 ? 1.0 : std::clamp(far, kCorrectionGain, 1.0);
  const Pose2<Map, Base> corrected{predicted.x_m + gain * (pose.x_m - predicted.x_m),
                                   predicted.y_m + gain * (pose.y_m - predicted.y_m),
                                   wrap_angle(predicted.yaw_rad + gain * wrap_angle(pose.yaw_rad - predicted.yaw_rad))};
  T_map_odom = corrected * odometry.T_odom_base.inverse();
  if (params.relocalize) doubt(odometry, points_base, T_base_laser.T.translation().head<2>(), pose);
  watch(pose);
}

/// Searches the whole map while scans fit less than for sure.
void Localizer::State::doubt(const Odometry& odometry, const std::vector<Eigen::Vector2d>& points_base,
                             const Eigen::Vector2d& laser_base, const Pose2<Map, Base>& pose) {
  doubts = evidence.fit >= params.sure_fit ? 0 : doubts + 1;
  if (doubts == 0) checked = false;
  if (doubts % kNextDoubt != kFirstDoubt) return;
  const double near_m = params.fit_distance_m;
  const auto found = internal::best_on_map(field, places, points_base, laser_base, near_m);
  const double here = internal::plausibility_of(field, points_base, laser_base, pose, near_m);
  checked = found.empty() || found[0].plausibility < here + kMuchBetter;
  const bool alone = found.size() == 1 || (found.size() > 1 && found[1].plausibility < found[0].plausibility - kUnlike);
  if (checked || !alone || found[0].fit < params.min_fit) return;
  stand_at(found[0].T_map_base, odometry);
  evidence.fit = found[0].fit;
  ++evidence.relocalizations;
}

void Localizer::State::stand_at(const Pose2<Map, Base>& pose, const Odometry& odometry) {
  spread(pose, kFoundSpread);
  T_map_odom = pose * odometry.T_odom_base.inverse();
  doubts = misfits = spreads = 0;
}

/// Spreads the particles, wider each time, while scans do not fit.
void Localizer::State::watch(const Pose2<Map, Base>& pose) {
  const bool fits = evidence.fit >= params.min_fit;
  const bool sure = evidence.fit >= params.sure_fit || checked || !params.relocalize;
  const bool steady =
      evidence.correction_m <= params.max_correction_m && evidence.correction_rad <= params.max_correction_rad;
  estimate.converged = fits && sure && steady && evidence.spread_m <= params.max_spread_m;
  misfits = fits ? 0 : misfits + 1;
  if (fits) spreads = 0;
  if (misfits < kLostScans) return;
  misfits = 0;
  spreads = std::min(spreads + 1, kMaxSpreads);
  spread(pose, {kLostSpreadM * spreads, radians(10.0 * spreads)});
}

Localizer::Localizer(const FloorGrid& map, const Pose2<Map, Base>& start, const StartSpread& spread,
                     const LocalizerParams& params, RandomStream random) {
  if (std::find(map.cells().begin(), map.cells().end(), Occupancy::kOccupied) == map.cells().end()) {
    throw ArgumentError("The map to localize on has no occupied cell; a map with walls is needed.");
  }
  state_ = std::make_unique<State>(map, params, std::move(random));
  state_->start = start;
  state_->estimate.T_map_base = start;
  state_->spread(start, spread);
}

Localizer::~Localizer() = default;
Localizer::Localizer(Localizer&&) noexcept = default;
Localizer& Localizer::operator=(Localizer&&) noexcept = default;

PoseEstimate Localizer::update(const Odometry& odometry, const LaserScan* scan,
                               const Transform<Base, Laser>& T_base_laser) {
  State& s = *state_;
  if (!s.started) {
    s.started = true;
    s.T_map_odom = s.start * odometry.T_odom_base.inverse();
    s.T_odom_base_filter = odometry.T_odom_base;
  }
  if (scan != nullptr) s.correct(odometry, *scan, T_base_laser);
  s.estimate.stamp = odometry.stamp;
  s.estimate.T_map_base = s.T_map_odom * odometry.T_odom_base;
  return s.estimate;
}

Pose2<Map, Odom> Localizer::T_map_odom() const { return state_->T_map_odom; }
const PoseEstimate& Localizer::estimate() const { return state_->estimate; }
const LocalizationEvidence& Localizer::evidence() const { return state_->evidence; }
bool Localizer::is_sure() const { return state_->evidence.fit >= state_->params.sure_fit; }

void Localizer::relocalize(const Pose2<Map, Base>& around, const StartSpread& spread) {
  State& s = *state_;
  s.spread(around, spread);
  const Pose2<Odom, Base> T_odom_base = s.T_map_odom.inverse() * s.estimate.T_map_base;
  s.estimate.T_map_base = around;
  s.estimate.converged = false;
  s.start = around;
  s.T_map_odom = around * T_odom_base.inverse();
  s.T_odom_base_filter = T_odom_base;
  s.misfits = s.spreads = 0;
}

}  // namespace amiss::localize
