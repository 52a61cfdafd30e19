// Adds the CPU time that the calling thread spends during its life to a sum. For benches: nothing depends on it.
#pragma once

#include <time.h>

namespace amiss::sim::internal {

class CpuMeter {
 public:
  explicit CpuMeter(double& sum_s) : sum_s_(sum_s), start_s_(now_s()) {}
  ~CpuMeter() { sum_s_ += now_s() - start_s_; }
  CpuMeter(const CpuMeter&) = delete;
  CpuMeter& operator=(const CpuMeter&) = delete;

 private:
  static double now_s() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
  }
  double& sum_s_;
  double start_s_;
};

}  // namespace amiss::sim::internal
