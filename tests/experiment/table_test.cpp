#include "experiment/table.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace amiss::experiment {
namespace {

TEST(Table, NumbersAreShort) {
  EXPECT_EQ(number_text(2.0), "2");
  EXPECT_EQ(number_text(0.1 + 0.2), "0.3");
  EXPECT_EQ(number_text(-1e-9), "0");
  EXPECT_EQ(number_text(1234567.25), "1234567.25");
  EXPECT_EQ(number_text(std::numeric_limits<double>::infinity()), "inf");
  EXPECT_EQ(number_text(-std::numeric_limits<double>::infinity()), "-inf");
  EXPECT_EQ(number_text(std::nan("")), "-");
}

TEST(Table, FieldsStayInTheirColumn) {
  EXPECT_EQ(to_tsv({{"a", "b"}, {{"1", "two\tlines\nof it"}}}), "a\tb\n1\ttwo lines of it\n");
}

TEST(Table, NumbersStandToTheRight) {
  EXPECT_EQ(to_columns({{"name", "count"}, {{"a", "5"}, {"longer", "12 (3 .. 4)"}}}),
            "name          count\na                 5\nlonger  12 (3 .. 4)\n");
  EXPECT_EQ(to_columns({{"name", "why"}, {{"a", "-"}, {"b", "-x"}}}), "name  why\na     -\nb     -x\n");
}

}  // namespace
}  // namespace amiss::experiment
