#include "world/class_table.hpp"

#include "core/result.hpp"
#include "files_for_test.hpp"

namespace amiss::world {
namespace {

class ClassTableTest : public FilesForTest {};

TEST_F(ClassTableTest, TheLongestBeginningThatEndsAtAWordCounts) {
  const ClassTable table({{"lamp", SemanticClass::kOtherProp},
                          {"lamp_floor", SemanticClass::kOtherFurniture},
                          {"chair", SemanticClass::kChair}});
  EXPECT_EQ(table.class_of("lamp_2"), SemanticClass::kOtherProp);
  EXPECT_EQ(table.class_of("lamp_floor_1"), SemanticClass::kOtherFurniture);
  EXPECT_EQ(table.class_of("chair"), SemanticClass::kChair);
  EXPECT_EQ(table.class_of("chair::seat"), SemanticClass::kChair);
  EXPECT_EQ(table.class_of("chairlift_1"), SemanticClass::kUnlabelled);
  EXPECT_EQ(table.class_of(""), SemanticClass::kUnlabelled);
}

TEST_F(ClassTableTest, WrongTablesAreRefusedWithTheirLine) {
  const auto why = [&](const std::string& text) -> std::string {
    const auto file = write("classes.yaml", text);
    try {
      static_cast<void>(load_class_table(file));
    } catch (const InputError& error) {
      return std::string(error.what()).substr(file.string().size());
    }
    return "";
  };
  EXPECT_EQ(why("chair: [chair]\nsofas: [couch]\n"), ":2: 'sofas' is no semantic class; did you mean 'sofa'?");
  EXPECT_EQ(why("chair: [a]\nsofa: [a]\n"), ":2: 'a' is there twice; a name has one class");
  EXPECT_EQ(why("chair: stool\n"), ":1: chair is not a list of names");
  EXPECT_EQ(why("- chair\n"), ":1: not a map; allowed is CLASS: [NAME, ..] for each class");
  EXPECT_NE(why("chair: [\n").find("not YAML"), std::string::npos);
  EXPECT_EQ(why("chair: [chair]\n"), "");
}

TEST_F(ClassTableTest, AWorldWithoutATableIsUnlabelled) {
  World world;
  world.file = "/nowhere/world.sdf";
  EXPECT_TRUE(class_table_beside(world).rows().empty());
}

}  // namespace
}  // namespace amiss::world
