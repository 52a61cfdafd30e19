// Results as JUnit XML, which CI servers show. Cases -> text. A failure is something expected that did not come, an
// error a program or an input that went wrong; the two stay apart.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace amiss::report {

struct JunitCase {
  enum class Kind { kPassed, kFailed, kError };
  std::string name, file;
  double seconds_s = 0.0;
  Kind kind = Kind::kPassed;
  std::string message;  // one sentence
  std::string details;
};

[[nodiscard]] std::string to_junit(std::string_view suite, const std::vector<JunitCase>& cases);

}  // namespace amiss::report
