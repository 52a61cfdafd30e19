#include "report/trajectory.hpp"

#include <cmath>
#include <cstdio>

namespace amiss::report {

void TumTrajectory::add(Stamp stamp, double x_m, double y_m, double yaw_rad) {
  char line[160];
  const int length = std::snprintf(line, sizeof line, "%.3f %.6f %.6f 0 0 0 %.9f %.9f\n", seconds(stamp), x_m, y_m,
                                   std::sin(0.5 * yaw_rad), std::cos(0.5 * yaw_rad));
  text_.append(line, static_cast<std::size_t>(length));
}

}  // namespace amiss::report
