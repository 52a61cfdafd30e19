#include "knowledge/knowledge_base.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <fstream>

#include "core/files.hpp"
#include "core/result.hpp"

namespace amiss::knowledge {
namespace {

Sighting sighting(double x, double y, double radius_m, double height_m = 0.1, int voxels = 10) {
  return {{x, y, height_m / 2.0}, {{x, y}, radius_m, 0.0, height_m}, voxels};
}
Stamp at(int second) { return Stamp(std::chrono::seconds(second)); }
const auto kEverywhere = [](const Region&) { return true; };
const auto kNowhere = [](const Region&) { return false; };

using Changes = std::vector<RegionChange>;

class File : public ::testing::Test {
 protected:
  void SetUp() override {
    folder_ = std::filesystem::temp_directory_path() /
              ("amiss_knowledge_" + std::string(::testing::UnitTest::GetInstance()->current_test_info()->name()));
    std::filesystem::remove_all(folder_);
    std::filesystem::create_directories(folder_);
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }
  [[nodiscard]] std::filesystem::path file() const { return folder_ / "knowledge.sqlite"; }
  std::filesystem::path folder_;
};

TEST(Merge, InsertsConfirmsAndWithdraws) {
  KnowledgeBase base{Params{}};
  EXPECT_EQ(base.merge({sighting(1, 1, 0.1), sighting(3, 1, 0.1)}, kEverywhere, at(1)),
            (Changes{{1, Change::kInserted}, {2, Change::kInserted}}));
  EXPECT_TRUE(base.merge({sighting(1.01, 1, 0.1)}, kNowhere, at(2)).empty());  // the other was not looked at
  EXPECT_EQ(base.now().regions[0].last_seen, at(2));
  EXPECT_EQ(base.now().regions[0].first_seen, at(1));
  EXPECT_EQ(base.merge({sighting(1, 1, 0.1)}, kEverywhere, at(3)), (Changes{{2, Change::kWithdrawn}}));
  ASSERT_EQ(base.open_regions().size(), 1U);
  EXPECT_EQ(base.open_regions()[0].id, 1);
}

TEST(Merge, UpdatesWhatHasGrown) {
  KnowledgeBase base{Params{}};
  (void)base.merge({sighting(1, 1, 0.1)}, kEverywhere, at(1));
  EXPECT_EQ(base.merge({sighting(1.03, 1, 0.13, 0.1, 14)}, kEverywhere, at(2)), (Changes{{1, Change::kGrown}}));
  EXPECT_EQ(base.now().regions[0].cylinder.radius_m, 0.13);
  EXPECT_TRUE(base.merge({sighting(1.03, 1, 0.11, 0.1, 12)}, kEverywhere, at(3)).empty());
  EXPECT_EQ(base.now().regions[0].cylinder.radius_m, 0.13);
}

TEST(Merge, AnExaminedRegionStaysExaminedUnlessItGrowsNoticeably) {
  KnowledgeBase base{Params{}};
  (void)base.merge({sighting(1, 1, 0.1)}, kEverywhere, at(1));
  base.mark_examined(1, at(2));
  EXPECT_TRUE(base.open_regions().empty());
  EXPECT_EQ(base.merge({sighting(1, 1, 0.13, 0.1, 14)}, kEverywhere, at(3)), (Changes{{1, Change::kGrown}}));
  EXPECT_TRUE(base.open_regions().empty());
  EXPECT_EQ(base.merge({sighting(1.1, 1, 0.25, 0.1, 40)}, kEverywhere, at(4)), (Changes{{1, Change::kReopened}}));
  EXPECT_EQ(base.open_regions().size(), 1U);
}

TEST(Merge, AnExaminedRegionThatFlickersIsNotExaminedTwice) {
  KnowledgeBase base{Params{}};
  (void)base.merge({sighting(1, 1, 0.1)}, kEverywhere, at(1));
  base.mark_examined(1, at(2));
  (void)base.merge({}, kEverywhere, at(3));
  EXPECT_TRUE(base.now().regions[0].withdrawn);
  EXPECT_EQ(base.merge({sighting(1, 1, 0.1)}, kEverywhere, at(4)), (Changes{{1, Change::kReturned}}));
  EXPECT_TRUE(base.open_regions().empty());
  EXPECT_FALSE(base.now().regions[0].withdrawn);
}

TEST(Merge, NearDuplicatesBecomeOne) {
  KnowledgeBase base{Params{}};
  EXPECT_EQ(base.merge({sighting(1, 1, 0.1), sighting(1.05, 1, 0.1)}, kEverywhere, at(1)).size(), 1U);
  (void)base.merge({sighting(1.025, 1, 0.125), sighting(1.4, 1, 0.1)}, kEverywhere, at(2));
  ASSERT_EQ(base.open_regions().size(), 2U);
  EXPECT_EQ(base.merge({sighting(1.2, 1, 0.35, 0.1, 60)}, kEverywhere, at(3)),
            (Changes{{1, Change::kGrown}, {2, Change::kAbsorbed}}));
  EXPECT_EQ(base.open_regions().size(), 1U);
}

TEST_F(File, KeepsEverythingThatIsKnown) {
  Knowledge before;
  {
    KnowledgeBase base(file(), Params{});
    (void)base.merge({sighting(1, 1, 0.1), sighting(3, 1, 0.1)}, kEverywhere, at(1));
    base.mark_examined(2, at(2));
    EXPECT_EQ(base.add_views({{0, {1, 2, 0.5}, 1.0, 2.0, false, {}}, {0, {3, 4, -0.5}, 1.0, 2.0, false, {}}}),
              (std::vector<int>{1, 2}));
    base.mark_visited(1, at(3));
    base.mark_dropped(2);
    EXPECT_EQ(base.add_object({0, 2, at(4), {3, 1, 0.05}, {0.2, 0.1, 0.1}, 1234}), 1);
    before = base.now();
    base.close();
    base.mark_examined(1, at(5));  // in memory only
  }
  const KnowledgeBase again(file(), Params{});
  EXPECT_EQ(again.now().regions, before.regions);
  EXPECT_EQ(again.now().objects, before.objects);
  ASSERT_EQ(again.now().views.size(), 2U);
  EXPECT_EQ(again.now().views[1].T_map_base.y_m, 4.0);
  EXPECT_EQ(again.now().views[1].T_map_base.yaw_rad, -0.5);
  EXPECT_TRUE(again.now().views[1].dropped);
  EXPECT_EQ(again.now().views[0].visited_at, at(3));
  EXPECT_FALSE(again.now().regions[0].examined);
}

TEST_F(File, OtherFilesAreRefusedInOneSentence) {
  const auto refused = [&](const std::string& bytes) {
    std::ofstream(file(), std::ios::binary) << bytes;
    try {
      const KnowledgeBase base(file(), Params{});
    } catch (const InputError& error) {
      const std::string what = error.what();
      EXPECT_NE(what.find(file().string()), std::string::npos);
      EXPECT_EQ(what.find('\n'), std::string::npos);
      EXPECT_EQ(what.back(), '.');
      return true;
    }
    return false;
  };
  EXPECT_TRUE(refused(""));
  EXPECT_TRUE(refused("hello"));
  EXPECT_TRUE(refused(std::string(5000, '\7')));
  std::filesystem::remove(file());
  {
    KnowledgeBase base(file(), Params{});
    for (int i = 0; i < 300; ++i) (void)base.add_object({0, 0, at(i), {1, 2, 3}, {1, 1, 1}, i});
  }
  const std::string whole = load_bytes(file());
  for (const std::size_t length : {std::size_t{10}, std::size_t{100}, std::size_t{4096}, whole.size() - 4096}) {
    EXPECT_TRUE(refused(whole.substr(0, length))) << length;
  }
  std::string other = whole;
  other[70] = 'x';  // the application's id
  EXPECT_TRUE(refused(other));
  EXPECT_THROW(KnowledgeBase(folder_, Params{}), InputError);
  EXPECT_THROW(KnowledgeBase(folder_ / "missing" / "knowledge.sqlite", Params{}), InputError);
}

TEST_F(File, AnyDamageIsRefusedOrHarmless) {
  {
    KnowledgeBase base(file(), Params{});
    for (int i = 0; i < 50; ++i) (void)base.merge({sighting(i, 1, 0.1)}, kNowhere, at(i));
  }
  const std::string whole = load_bytes(file());
  EXPECT_TRUE(rc::check([&] {
    std::string damaged = whole;
    const auto hits = *rc::gen::inRange(1, 20);
    for (int i = 0; i < hits; ++i) {
      damaged[*rc::gen::inRange<std::size_t>(0, damaged.size())] = static_cast<char>(*rc::gen::inRange(0, 256));
    }
    std::ofstream(file(), std::ios::binary) << damaged;
    try {
      const KnowledgeBase base(file(), Params{});
      RC_ASSERT(base.now().regions.size() <= 50U);
    } catch (const InputError&) {
    }
  }));
}

TEST_F(File, TwoProgramsDoNotShareAFile) {
  KnowledgeBase first(file(), Params{});
  (void)first.merge({sighting(1, 1, 0.1)}, kNowhere, at(1));
  EXPECT_THROW(KnowledgeBase(file(), Params{}), InputError);
}

RC_GTEST_PROP(Merge, KeepsItsPromises, ()) {
  KnowledgeBase base{Params{}};
  const int rounds = *rc::gen::inRange(1, 6);
  for (int round = 0; round < rounds; ++round) {
    std::vector<Sighting> seen;
    const int n = *rc::gen::inRange(0, 8);
    for (int i = 0; i < n; ++i) {
      seen.push_back(sighting(*rc::gen::inRange(0, 30) / 10.0, *rc::gen::inRange(0, 30) / 10.0,
                              *rc::gen::inRange(3, 40) / 100.0, 0.1, *rc::gen::inRange(4, 100)));
    }
    (void)base.merge(seen, kEverywhere, at(round));
    const auto& regions = base.now().regions;
    for (const Sighting& s : seen) {  // every sighting lies in a region that is not withdrawn
      RC_ASSERT(std::any_of(regions.begin(), regions.end(), [&](const Region& r) {
        const double d = (r.cylinder.centre_map - s.cylinder.centre_map).norm();
        return !r.withdrawn && d <= r.cylinder.radius_m + s.cylinder.radius_m;
      }));
    }
    const std::vector<Region> open = base.open_regions();
    RC_ASSERT(open.size() <= seen.size());
    const Knowledge before = base.now();  // the same again changes nothing but last_seen
    for (const RegionChange& change : base.merge(seen, kEverywhere, at(round))) RC_FAIL(std::to_string(change.region));
    RC_ASSERT(base.now().regions == before.regions);
  }
}

}  // namespace
}  // namespace amiss::knowledge
