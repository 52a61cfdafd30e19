#include "dataset/annotation_file.hpp"

#include <gtest/gtest.h>

#include "core/result.hpp"

namespace amiss::dataset {
namespace {

TEST(AnnotationFile, LinesAreReadAsObChangeWritesThem) {
  const auto objects = parse_annotations("mug 0 2 5 false\n\n  bowl 1\ncracker_box true\nmug 7 false\r\n", "a", 8);
  ASSERT_EQ(objects.size(), 3U);
  EXPECT_EQ(objects[0].name, "mug");
  EXPECT_EQ(objects[0].points, (std::vector<std::uint32_t>{0, 2, 5, 7}));
  EXPECT_EQ(objects[0].on_floor, false);
  EXPECT_FALSE(objects[1].on_floor.has_value());
  EXPECT_TRUE(objects[2].points.empty());
  EXPECT_EQ(objects[2].on_floor, true);
  const auto again = parse_annotations(annotation_bytes(objects), "b", 8);
  ASSERT_EQ(again.size(), 3U);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(again[i].name, objects[i].name);
    EXPECT_EQ(again[i].points, objects[i].points);
    EXPECT_EQ(again[i].on_floor, objects[i].on_floor);
  }
}

TEST(AnnotationFile, WrongLinesAreRefusedWithTheirNumber) {
  const auto why = [](const char* text) -> std::string {
    try {
      static_cast<void>(parse_annotations(text, "f", 10));
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_EQ(why("mug 1\nbowl 10\n"), "f:2: point 10 is not there; the cloud has 10");
  EXPECT_EQ(why("mug 1 two\n"), "f:1: 'two' is no index of a point");
  EXPECT_EQ(why("mug -1\n"), "f:1: '-1' is no index of a point");
  EXPECT_EQ(why("mug 99999999999\n"), "f:1: '99999999999' is no index of a point");
  EXPECT_EQ(why("true\n"), "f:1: a line must begin with the object's name");
  EXPECT_EQ(why(""), "");
}

TEST(AnnotationFile, TheAirplaneLiesInParts) {
  const auto objects = parse_annotations("toy_airplane 1 2\nmug 3\nairplane_wing 4 false\n", "f", 10);
  ASSERT_EQ(objects.size(), 2U);
  EXPECT_EQ(objects[0].name, "toy_airplane");
  EXPECT_EQ(objects[0].points, (std::vector<std::uint32_t>{1, 2, 4}));
  EXPECT_EQ(objects[0].on_floor, false);
  EXPECT_EQ(objects[1].name, "mug");
}

}  // namespace
}  // namespace amiss::dataset
