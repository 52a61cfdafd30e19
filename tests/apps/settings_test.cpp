#include "settings.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <set>

namespace amiss::app {
namespace {

namespace fs = std::filesystem;

TEST(Settings, EveryKeyStandsOnceAndEveryDefaultIsAllowed) {
  Settings settings;
  std::set<std::string> keys;
  const ParamTable table = settings.table();
  for (const ParamTable::Row& row : table.rows()) {
    EXPECT_TRUE(keys.insert(row.key).second) << row.key << " stands twice";
    EXPECT_TRUE(row.parse(row.print())) << row.key << " = " << row.print() << ", allowed: " << row.allowed;
  }
}

TEST(Settings, AllFilesThatComeWithAmissLoad) {
  const std::string defaults = Settings().table().to_yaml();
  int files = 0;
  for (const auto& entry : fs::directory_iterator(AMISS_SOURCE_DIR "/share/params")) {
    if (entry.path().extension() != ".yaml") continue;
    ++files;
    EXPECT_NE(load_settings(entry.path(), {}).table().to_yaml(), defaults) << entry.path() << " changes nothing";
  }
  EXPECT_GE(files, 1);
}

TEST(Settings, Table41HasTheValuesOfTheThesis) {
  const Settings settings = load_settings(AMISS_SOURCE_DIR "/share/params/table_4_1.yaml", {});
  EXPECT_EQ(settings.mission.region.min_voxels, 4);
}

TEST(Settings, OverridesComeAfterTheFile) {
  const Settings settings = load_settings(AMISS_SOURCE_DIR "/share/params/table_4_1.yaml", {"change.min_voxels=7"});
  EXPECT_EQ(settings.mission.region.min_voxels, 7);
}

TEST(Settings, TheReferenceDependsOnWhatTheMappingRunUses) {
  Settings plain, searching = load_settings("", {"search.look=1", "referee.max_error=0.2"}),
                  mapping = load_settings("", {"mapping.resolution=0.1"});
  EXPECT_EQ(searching.reference_key(), plain.reference_key());
  EXPECT_NE(mapping.reference_key(), plain.reference_key());
}

}  // namespace
}  // namespace amiss::app
