// Laser and odometry of a recording as a CARMEN log, which gmapping, MRPT (carmen2rawlog) and others read.
// in: scans and odometry in the order of time   out: text, one line each: ODOM, ROBOTLASER1 (the pose of the laser and
// the robot's are those of odometry). A beam that did not return is written as the laser's maximum range.
#pragma once

#include <string>

#include "core/sensors.hpp"

namespace amiss::dataset {

class CarmenLog {
 public:
  void add(const Odometry& odometry);
  /// The odometry is of the scan's instant.
  void add(const LaserScan& scan, const Odometry& odometry, const Transform<Base, Laser>& T_base_laser);
  [[nodiscard]] const std::string& bytes() const { return text_; }

 private:
  std::string text_ = "# CARMEN Logfile: lengths in m, angles in rad, times in s\n";
};

}  // namespace amiss::dataset
