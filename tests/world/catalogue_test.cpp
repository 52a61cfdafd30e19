#include "world/catalogue.hpp"

#include "core/result.hpp"
#include "files_for_test.hpp"

namespace amiss::world {
namespace {

class CatalogueTest : public FilesForTest {
 protected:
  void add(const std::string& shelf, const std::string& name, const std::string& size) const {
    write(shelf + "/" + name + "/model.sdf", as_file(box_model(name, size)));
  }
};

TEST_F(CatalogueTest, ListsObjectsByNameWithLabelAndSize) {
  add("a", "red_cup", "0.08 0.08 0.10");
  add("a", "book", "0.20 0.14 0.03");
  write("a/book/model.config", "<model><name>A thick book</name><sdf version='1.7'>model.sdf</sdf></model>");
  write("a/notes/readme.txt", "no object");
  const Catalogue catalogue = load_catalogue({folder_ / "a"});
  ASSERT_EQ(catalogue.entries.size(), 2U);
  EXPECT_EQ(catalogue.entries[0].name, "book");
  EXPECT_EQ(catalogue.entries[0].label, "A thick book");
  EXPECT_EQ(catalogue.entries[1].label, "red cup");
  EXPECT_LT((catalogue.at("red_cup").size_m - Eigen::Vector3d(0.08, 0.08, 0.10)).norm(), 1e-9);
  EXPECT_EQ(catalogue.at("red_cup").body.name, "red_cup");
  EXPECT_FALSE(catalogue.at("red_cup").body.is_static);
  EXPECT_EQ(catalogue.find("cup"), nullptr);
}

TEST_F(CatalogueTest, LaterFoldersReplaceEarlierOnes) {
  add("a", "cup", "1 1 1");
  add("b", "cup", "2 2 2");
  const Catalogue catalogue = load_catalogue({folder_ / "a", folder_ / "b"});
  ASSERT_EQ(catalogue.entries.size(), 1U);
  EXPECT_NEAR(catalogue.at("cup").size_m.x(), 2.0, 1e-9);
}

TEST_F(CatalogueTest, NamesTheNearestWhereOneIsUnknown) {
  add("a", "mustard_bottle", "0.1 0.1 0.2");
  const Catalogue catalogue = load_catalogue({folder_ / "a"});
  try {
    (void)catalogue.at("mustard_botle");
    FAIL() << "found what is not there";
  } catch (const ArgumentError& error) {
    EXPECT_NE(std::string(error.what()).find("did you mean 'mustard_bottle'?"), std::string::npos) << error.what();
  }
}

TEST_F(CatalogueTest, RefusesFoldersWithoutObjectsAndBrokenObjects) {
  EXPECT_THROW((void)load_catalogue({folder_ / "absent"}), InputError);
  EXPECT_THROW((void)load_catalogue({folder_}), InputError);
  write("b/ghost/model.sdf", as_file("<model name='ghost'><link name='l'/></model>"));
  EXPECT_THROW((void)load_catalogue({folder_ / "b"}), InputError);
  write("c/torn/model.sdf", "<sdf version='1.7'><model");
  EXPECT_THROW((void)load_catalogue({folder_ / "c"}), InputError);
}

TEST(OwnObjectsTest, EveryObjectOfTheProjectLoadsWithoutWarnings) {
  const std::filesystem::path folder = std::filesystem::path(AMISS_SOURCE_DIR) / "share" / "objects";
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << "no objects in this tree";
  const Catalogue catalogue = load_catalogue({folder});
  EXPECT_TRUE(catalogue.warnings.empty()) << catalogue.warnings.front();
  for (const CatalogueEntry& entry : catalogue.entries) {
    EXPECT_GT(entry.size_m.minCoeff(), 0.001) << entry.name;
    EXPECT_LT(entry.size_m.maxCoeff(), 1.0) << entry.name;
    EXPECT_GT(entry.body.mass_kg, 0.0) << entry.name;
    EXPECT_FALSE(entry.body.visuals.empty()) << entry.name;
  }
}

}  // namespace
}  // namespace amiss::world
