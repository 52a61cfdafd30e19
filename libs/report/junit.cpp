#include "report/junit.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace amiss::report {

namespace {

/// Control characters are not allowed in XML 1.0 and become '?'.
std::string escaped(std::string_view text) {
  std::string out;
  for (const char c : text) {
    const bool control = static_cast<unsigned char>(c) < 0x20 && c != '\n' && c != '\t';
    if (c == '&') {
      out += "&amp;";
    } else if (c == '<') {
      out += "&lt;";
    } else if (c == '>') {
      out += "&gt;";
    } else if (c == '"') {
      out += "&quot;";
    } else if (c == '\n') {
      out += "&#10;";
    } else {
      out += control ? '?' : c;
    }
  }
  return out;
}

std::string element(const JunitCase& c) {
  const std::string head = fmt::format(R"(  <testcase name="{}" classname="{}" file="{}" time="{:.3f}")",
                                       escaped(c.name), "scenario", escaped(c.file), c.seconds_s);
  if (c.kind == JunitCase::Kind::kPassed) return head + "/>\n";
  const char* tag = c.kind == JunitCase::Kind::kFailed ? "failure" : "error";
  return head + fmt::format(">\n    <{0} message=\"{1}\">{2}</{0}>\n  </testcase>\n", tag, escaped(c.message),
                            escaped(c.details));
}

}  // namespace

std::string to_junit(std::string_view suite, const std::vector<JunitCase>& cases) {
  const auto count = [&](JunitCase::Kind kind) {
    return std::count_if(cases.begin(), cases.end(), [&](const JunitCase& c) { return c.kind == kind; });
  };
  double seconds_s = 0.0;
  std::string body;
  for (const JunitCase& c : cases) {
    seconds_s += c.seconds_s;
    body += element(c);
  }
  return fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
      "<testsuite name=\"{}\" tests=\"{}\" failures=\"{}\" errors=\"{}\" time=\"{:.3f}\">\n{}</testsuite>\n",
      escaped(suite), cases.size(), count(JunitCase::Kind::kFailed), count(JunitCase::Kind::kError), seconds_s, body);
}

}  // namespace amiss::report
