// Trajectories as TUM text (evo reads it): "t x y z qx qy qz qw" a line, seconds and metres.
#pragma once

#include <string>

#include "core/frames.hpp"
#include "core/stamp.hpp"

namespace amiss::report {

class TumTrajectory {
 public:
  void add(Stamp stamp, double x_m, double y_m, double yaw_rad);
  [[nodiscard]] const std::string& text() const { return text_; }

 private:
  std::string text_ = "# t[s] x[m] y[m] z[m] qx qy qz qw\n";
};

}  // namespace amiss::report
