#include "dataset/instance_images.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include "core/files.hpp"
#include "core/result.hpp"

namespace amiss::dataset {
namespace {

class InstanceImagesTest : public ::testing::Test {
 protected:
  void SetUp() override { std::filesystem::create_directories(folder_); }
  void TearDown() override { std::filesystem::remove_all(folder_); }
  std::filesystem::path folder_ =
      std::filesystem::temp_directory_path() / ("amiss_instances_" + std::to_string(getpid()));
};

TEST_F(InstanceImagesTest, ImagesComeBackByTheirTime) {
  InstanceWriter writer(folder_);
  std::vector<std::uint16_t> numbers(12, 0);
  numbers[3] = 1;
  numbers[7] = 65535;
  const Stamp stamp(std::chrono::milliseconds(1234));
  writer.add(stamp, 4, 3, numbers);
  writer.add(stamp + std::chrono::seconds(1), 4, 3, std::vector<std::uint16_t>(12, 9));
  writer.finish();
  const InstanceImages images(folder_);
  EXPECT_EQ(images.size(), 2U);
  EXPECT_EQ(images.load(stamp), numbers);
  EXPECT_FALSE(images.load(stamp + std::chrono::milliseconds(1)).has_value());
}

TEST_F(InstanceImagesTest, TablesComeBackAndWrongOnesAreRefused) {
  const std::vector<Instance> table{{1, "floor_room", "", SemanticClass::kFloor, false},
                                    {40, "mug", "mug", SemanticClass::kOtherProp, true}};
  save_instances(folder_ / "instances.tsv", table);
  const auto read = load_instances(folder_ / "instances.tsv");
  ASSERT_EQ(read.size(), 2U);
  EXPECT_EQ(read[0].name, "floor_room");
  EXPECT_TRUE(read[0].kind.empty());
  EXPECT_EQ(read[0].value, SemanticClass::kFloor);
  EXPECT_EQ(read[1].number, 40);
  EXPECT_TRUE(read[1].on_floor);
  const auto why = [&](const std::string& line) -> std::string {
    save_atomically(folder_ / "t.tsv", "number\tname\tkind\tclass\ton_floor\n" + line + "\n");
    try {
      static_cast<void>(load_instances(folder_ / "t.tsv"));
    } catch (const InputError& error) {
      return std::string(error.what()).substr((folder_ / "t.tsv").string().size());
    }
    return "";
  };
  EXPECT_EQ(why("0\ta\t\twall\tno"), ":2: the number of a body must be a whole one from 1 to 65535");
  EXPECT_EQ(why("1\ta\t\tlamp\tno"), ":2: 'lamp' is no semantic class");
  EXPECT_EQ(why("1\ta\t\twall\tmaybe"), ":2: on_floor must be yes or no");
  EXPECT_NE(why("1\ta\twall").find("five fields"), std::string::npos);
}

}  // namespace
}  // namespace amiss::dataset
