#include "report/junit.hpp"

#include <gtest/gtest.h>

namespace amiss::report {
namespace {

using Kind = JunitCase::Kind;

TEST(Junit, KeepsFailuresAndErrorsApart) {
  const std::string xml = to_junit("scenarios", {{"a", "a.yaml", 1.5, Kind::kPassed, "", ""},
                                                 {"b", "b.yaml", 0.5, Kind::kFailed, "mug was not found", "log"},
                                                 {"c", "c.yaml", 0.25, Kind::kError, "signal 11", ""}});
  EXPECT_EQ(xml,
            "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
            "<testsuite name=\"scenarios\" tests=\"3\" failures=\"1\" errors=\"1\" time=\"2.250\">\n"
            "  <testcase name=\"a\" classname=\"scenario\" file=\"a.yaml\" time=\"1.500\"/>\n"
            "  <testcase name=\"b\" classname=\"scenario\" file=\"b.yaml\" time=\"0.500\">\n"
            "    <failure message=\"mug was not found\">log</failure>\n"
            "  </testcase>\n"
            "  <testcase name=\"c\" classname=\"scenario\" file=\"c.yaml\" time=\"0.250\">\n"
            "    <error message=\"signal 11\"></error>\n"
            "  </testcase>\n"
            "</testsuite>\n");
}

TEST(Junit, EscapesWhatXmlMustNotHold) {
  const std::string xml = to_junit("s", {{"<a&\"b\">", "f", 0, Kind::kFailed, "x\ny", std::string("\x01", 1)}});
  EXPECT_NE(xml.find("name=\"&lt;a&amp;&quot;b&quot;&gt;\""), std::string::npos) << xml;
  EXPECT_NE(xml.find("message=\"x&#10;y\">?<"), std::string::npos) << xml;
}

}  // namespace
}  // namespace amiss::report
