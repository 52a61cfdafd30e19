#include "change/novel.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "change/room.hpp"
#include "core/result.hpp"

namespace amiss::change {
namespace {

using segment::Indices;

Indices found_points(const Detection& detection) {
  Indices all;
  for (const NovelObject& object : detection.objects) all.insert(all.end(), object.points.begin(), object.points.end());
  std::sort(all.begin(), all.end());
  return all;
}

double share(const Indices& of, const Indices& in) {
  Indices both;
  std::set_intersection(of.begin(), of.end(), in.begin(), in.end(), std::back_inserter(both));
  return of.empty() ? 0.0 : static_cast<double>(both.size()) / static_cast<double>(of.size());
}

void expect_found(const Detection& detection, const Indices& truth, std::size_t objects = 1) {
  EXPECT_EQ(detection.objects.size(), objects);
  EXPECT_GT(share(truth, found_points(detection)), 0.8);   // recall; its foot is as high as the table's noise
  EXPECT_GT(share(found_points(detection), truth), 0.95);  // precision
}

Room furnished(std::uint64_t seed) {
  Room room(seed);
  add_lamp(room, 0.9F, 0.2F);
  add_keyboard(room, 0.2F, 0.3F);
  return room;
}

TEST(Novel, SameRoomHoldsNothing) {
  for (const char* method : {"local-verification", "metaroom"}) {
    EXPECT_TRUE(detect_novel(furnished(1).scene(), furnished(2).scene(), method).objects.empty()) << method;
  }
}

TEST(Novel, ObjectIsFoundInARoomThatLiesElsewhere) {
  Room now = furnished(2);
  const std::size_t before = now.size();
  add_can(now, 0.5F, 0.1F);
  const Scene current = now.shifted({0.03F, -0.02F, 0.004F}, 0.01F);
  const Detection detection = detect_novel(furnished(1).scene(), current, "local-verification");
  expect_found(detection, now.since(before));
  EXPECT_NEAR(detection.turn_rad, -0.01, 0.003);
}

TEST(Novel, SurfacesAreThoseThatBothRoomsHave) {
  Room now(2);
  now.box({0.5F, 0.1F, 0.70F}, {0.25F, 0.25F, 0.20F}, 0.0F, kBlue, SemanticClass::kOtherProp);  // has a level top
  EXPECT_EQ(detect_novel(Room(1).scene(), now.scene(), "local-verification").planes, 2);        // floor and table
}

TEST(Novel, PermanentThingsMayMoveALittle) {
  Room now(2);
  add_lamp(now, 0.95F, 0.16F, 0.1F);
  add_keyboard(now, 0.12F, 0.36F, -0.15F);
  const Detection detection = detect_novel(furnished(1).scene(), now.scene(), "local-verification");
  EXPECT_TRUE(detection.objects.empty());
  const auto moved = [](const Decision& d) { return d.verdict == Verdict::kMovedALittle; };
  EXPECT_GE(std::count_if(detection.decisions.begin(), detection.decisions.end(), moved), 2);
}

TEST(Novel, ObjectThatTouchesAPermanentThingIsFoundAlone) {
  for (const bool nudged : {false, true}) {
    Room now(2);
    add_keyboard(now, 0.2F, 0.3F);
    const float x = nudged ? 0.95F : 0.9F;
    add_lamp(now, x, 0.2F);
    const std::size_t before = now.size();
    now.box({x + 0.12F, 0.2F, 0.70F}, {0.06F, 0.10F, 0.16F}, 0.0F, kBlue, SemanticClass::kOtherProp);
    expect_found(detect_novel(furnished(1).scene(), now.scene(), "local-verification"), now.since(before));
  }
}

TEST(Novel, SmallObjectThatWouldFitAStandingOneIsFound) {
  Room reference(1), now(2);
  add_can(reference, 0.5F, 0.3F, kGrey);
  add_can(now, 0.5F, 0.3F, kGrey);
  const std::size_t before = now.size();
  add_can(now, 0.62F, 0.3F, kGrey);  // 5 cm beside its double, nearer than c_ref
  const Detection detection = detect_novel(reference.scene(), now.scene(), "local-verification");
  expect_found(detection, now.since(before));
  const auto novel = std::find_if(detection.decisions.begin(), detection.decisions.end(),
                                  [](const Decision& d) { return d.verdict == Verdict::kNovel; });
  ASSERT_NE(novel, detection.decisions.end());
  EXPECT_EQ(novel->object, 0U);
  EXPECT_GT(novel->overlap_moved, 0.7);  // the thesis would have dropped it
  EXPECT_GT(novel->taken, 0.5);
}

TEST(Novel, SmallObjectThatWouldFitPartOfWhatHasGoneIsFound) {
  Room reference(1), now(2);
  reference.box({0.5F, 0.2F, 0.70F}, {0.40F, 0.14F, 0.30F}, 0.0F, kGrey, SemanticClass::kOtherProp);
  const std::size_t before = now.size();
  now.box({0.40F, 0.2F, 0.70F}, {0.08F, 0.05F, 0.12F}, 0.0F, kGrey, SemanticClass::kOtherProp);
  expect_found(detect_novel(reference.scene(), now.scene(), "local-verification"), now.since(before));
}

TEST(Novel, ColourTellsAnotherThingInTheSamePlaceNearby) {
  Room reference(1), now(2);
  add_can(reference, 0.5F, 0.3F, kBlue);
  const std::size_t before = now.size();
  add_can(now, 0.62F, 0.3F, kRed);
  expect_found(detect_novel(reference.scene(), now.scene(), "local-verification"), now.since(before));
  Room same(3);
  add_can(same, 0.62F, 0.3F, kBlue);
  EXPECT_TRUE(detect_novel(reference.scene(), same.scene(), "local-verification").objects.empty());
}

TEST(Novel, NothingIsSaidWhereTheReferenceDidNotLook) {
  Room now = furnished(2);
  const std::size_t before = now.size();
  add_can(now, 0.5F, 0.1F);
  Scene reference = furnished(1).scene();
  mapping::VoxelMapParams voxels;
  voxels.resolution_m = 0.02;
  reference.space = mapping::VoxelMap(voxels);
  const Detection blind = detect_novel(reference, now.scene(), "local-verification");
  EXPECT_TRUE(blind.objects.empty());
  ASSERT_TRUE(std::any_of(blind.decisions.begin(), blind.decisions.end(),
                          [](const Decision& d) { return d.verdict == Verdict::kUnseen && d.unseen == 1.0; }));
  for (float x = 0.45F; x < 0.62F; x += 0.01F) {
    for (float y = 0.05F; y < 0.22F; y += 0.01F) {
      for (float z = 0.70F; z < 0.85F; z += 0.01F) {
        const Eigen::Vector3d place = Eigen::Vector3f(x, y, z).cast<double>();
        reference.space->set(reference.space->voxel_at(place), Occupancy::kFree);
      }
    }
  }
  expect_found(detect_novel(reference, now.scene(), "local-verification"), now.since(before));
}

bool decided(const Detection& detection, Verdict verdict) {
  return std::any_of(detection.decisions.begin(), detection.decisions.end(),
                     [&](const Decision& d) { return d.verdict == verdict; });
}

TEST(Novel, FlatObjectBesideAPermanentThingIsFound) {
  Room now = furnished(2);
  const std::size_t before = now.size();
  now.box({0.74F, 0.2F, 0.70F}, {0.16F, 0.12F, 0.024F}, 0.0F, kBlue, SemanticClass::kOtherProp);  // touches the lamp
  const Detection detection = detect_novel(furnished(1).scene(), now.scene(), "local-verification");
  EXPECT_EQ(detection.objects.size(), 1U);
  EXPECT_GT(share(now.since(before), found_points(detection)), 0.6);
  EXPECT_GT(share(found_points(detection), now.since(before)), 0.95);
}

TEST(Novel, EdgesOfNudgedFurnitureAreNoObjects) {
  Room reference(1);
  const auto add_sideboard = [](Room& room) {  // wider than what is taken for movable as a whole
    room.box({-0.3F, -0.45F, 0.0F}, {1.7F, 0.25F, 0.4F}, 0.0F, kGrey, SemanticClass::kCabinet);
  };
  add_sideboard(reference);
  for (const bool nudged : {true, false}) {
    Room now(2);
    add_sideboard(now);
    now.box({0.2F, -0.2F, 0.05F}, {0.4F, nudged ? 0.025F : 0.08F, 0.3F}, 0.0F, kGrey, SemanticClass::kCabinet);
    const Detection detection = detect_novel(reference.scene(), now.scene(), "local-verification");
    EXPECT_EQ(decided(detection, Verdict::kNudged), nudged);
    EXPECT_EQ(detection.objects.empty(), nudged);
  }
}

TEST(Novel, FlatThingIsFoundByItsColourAlone) {
  const auto add_sheet = [](Room& room, Rgb colour) {
    room.box({0.3F, 0.2F, 0.70F}, {0.16F, 0.12F, 0.004F}, 0.0F, colour, SemanticClass::kTable);
  };
  const auto detect = [](const Room& now) {
    return detect_novel(Room(1).scene(), now.scene(), "local-verification").objects;
  };
  Room table_coloured(2), shaded(2), blue(2);
  add_sheet(table_coloured, {150, 110, 70});
  EXPECT_TRUE(detect(table_coloured).empty());
  add_sheet(shaded, {60, 44, 28});  // the mean of both is two thirds of the table's colour
  EXPECT_TRUE(detect(shaded).empty());
  const std::size_t before = blue.size();
  add_sheet(blue, {20, 20, 220});
  const Detection detection = detect_novel(Room(1).scene(), blue.scene(), "local-verification");
  ASSERT_EQ(detection.objects.size(), 1U);
  EXPECT_GT(share(blue.since(before), found_points(detection)), 0.9);
  EXPECT_EQ(detection.decisions.back().source, "colour");
  Scene grey = blue.scene();
  grey.cloud.colours.clear();
  EXPECT_TRUE(detect_novel(Room(1).scene(), grey, "local-verification").objects.empty());
}

TEST(Novel, FlatThingThatWasNudgedIsNoObject) {
  const auto with_mat = [](std::uint64_t seed, float x) {
    Room room(seed);
    room.box({x, 0.2F, 0.70F}, {0.3F, 0.2F, 0.004F}, 0.0F, kBlue, SemanticClass::kTable);
    return room.scene();
  };
  EXPECT_TRUE(detect_novel(with_mat(1, 0.3F), with_mat(2, 0.36F), "local-verification").objects.empty());
}

TEST(Novel, ObjectBesideANudgedEdgeIsFoundWithoutIt) {
  const auto add_sideboard = [](Room& room) {
    room.box({-0.3F, -0.45F, 0.0F}, {1.7F, 0.25F, 0.4F}, 0.0F, kGrey, SemanticClass::kCabinet);
  };
  Room reference(1), now(2);
  add_sideboard(reference);
  add_sideboard(now);
  now.box({0.2F, -0.2F, 0.05F}, {0.4F, 0.025F, 0.3F}, 0.0F, kGrey, SemanticClass::kCabinet);
  const std::size_t before = now.size();
  now.box({0.3F, -0.17F, 0.05F}, {0.1F, 0.09F, 0.2F}, 0.0F, kGrey, SemanticClass::kOtherProp);
  const Detection detection = detect_novel(reference.scene(), now.scene(), "local-verification");
  EXPECT_TRUE(decided(detection, Verdict::kNudged));
  ASSERT_EQ(detection.objects.size(), 1U);
  EXPECT_GT(share(found_points(detection), now.since(before)), 0.8);
}

TEST(Novel, MoreOfAWallIsNoObjectUnlessItsPlaceWasSeenEmpty) {
  const auto in_hole = [](const Eigen::Vector3f& p) {
    return p.y() > 1.05F && p.x() > 0.3F && p.x() < 0.5F && p.z() > 0.1F;
  };
  const Scene whole = Room(1).scene(), now = Room(2).scene();
  Scene reference;
  mapping::VoxelMapParams voxels;
  voxels.resolution_m = 0.02;
  for (const std::optional<Occupancy> hole : {std::optional(Occupancy::kOccupied), std::optional(Occupancy::kFree),
                                              std::optional<Occupancy>()}) {  // none: nobody knows what was seen
    reference = {};
    reference.space = mapping::VoxelMap(voxels);
    for (std::size_t i = 0; i < whole.cloud.points.size(); ++i) {
      const Eigen::Vector3f& p = whole.cloud.points[i];
      if (!in_hole(p)) {
        reference.cloud.points.push_back(p);
        reference.cloud.colours.push_back(whole.cloud.colours[i]);
        continue;
      }
      for (const double y : {1.09, 1.11}) {
        reference.space->set(reference.space->voxel_at({p.cast<double>().x(), y, p.cast<double>().z()}),
                             hole.value_or(Occupancy::kFree));
      }
    }
    if (!hole) reference.space.reset();
    const Detection detection = detect_novel(reference, now, "local-verification");
    EXPECT_EQ(decided(detection, Verdict::kContinued), hole != Occupancy::kFree);
    EXPECT_EQ(detection.objects.empty(), hole != Occupancy::kFree);
  }
}

TEST(Novel, VariantsUseWhatTheySay) {
  Room now = furnished(2);
  const std::size_t before = now.size();
  add_can(now, 0.5F, 0.1F);
  const Scene reference = furnished(1).scene(true), current = now.scene(true);
  const NovelDetector detector(reference, current);
  expect_found(detector.detect("no-planes"), now.since(before));
  EXPECT_EQ(detector.detect("semantic").objects.size(), 3U);                      // lamp, keyboard, can
  EXPECT_EQ(detector.detect("no-verification").objects.size(), 3U);               // the table's rim is too large
  EXPECT_TRUE(detect_novel(reference, now.scene(), "semantic").objects.empty());  // no labels, no otherprop
  expect_found(detector.detect("metaroom"), now.since(before));
}

TEST(Novel, OctomapSeesLargeThingsOnly) {
  Room now = furnished(2);
  const std::size_t before = now.size();
  now.box({0.5F, 0.02F, 0.70F}, {0.15F, 0.15F, 0.25F}, 0.0F, kBlue, SemanticClass::kOtherProp);
  const Scene reference = furnished(1).scene();
  const Detection detection = detect_novel(reference, now.scene(), "octomap");
  ASSERT_EQ(detection.objects.size(), 1U);
  EXPECT_GT(share(now.since(before), found_points(detection)), 0.5);
  Room flat = furnished(2);  // no higher than the voxels that hold the table top
  flat.box({0.5F, 0.1F, 0.70F}, {0.10F, 0.10F, 0.03F}, 0.0F, kBlue, SemanticClass::kOtherProp);
  EXPECT_TRUE(detect_novel(reference, flat.scene(), "octomap").objects.empty());
}

TEST(Novel, IsRepeatable) {
  Room now = furnished(2);
  add_can(now, 0.5F, 0.1F);
  const auto a = detect_novel(furnished(1).scene(), now.scene(), "local-verification");
  const auto b = detect_novel(furnished(1).scene(), now.scene(), "local-verification");
  EXPECT_EQ(found_points(a), found_points(b));
}

TEST(Novel, WrongInputIsRefused) {
  const Scene scene = Room(1).scene(true);
  EXPECT_THROW((void)detect_novel(scene, scene, "magic"), ArgumentError);
  EXPECT_THROW((void)detect_novel({}, scene, "metaroom"), ArgumentError);
  Scene broken = scene;
  broken.labels.pop_back();
  EXPECT_THROW((void)detect_novel(scene, broken, "metaroom"), ArgumentError);
  broken = scene;
  broken.cloud.points.front().x() = std::nanf("");
  EXPECT_THROW((void)detect_novel(broken, scene, "metaroom"), ArgumentError);
}

}  // namespace
}  // namespace amiss::change
