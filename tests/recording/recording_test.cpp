#include "recording/recording.hpp"

#include <gtest/gtest.h>

#include "core/result.hpp"
#include "core/temporary_folder.hpp"
#include "recording/mcap_writer.hpp"

namespace amiss::recording {
namespace {

TEST(Recording, AnotherMcapFileIsRefused) {
  const test::TemporaryFolder folder;
  McapWriter writer(folder.path() / "other.mcap", "ros2");
  writer.write(writer.add_channel("/a", "cdr", "x/msg/A", "ros2msg", "int32 a\n"), {}, "1234");
  writer.close();
  const std::string said = test::sentence_of<InputError>([&] { Recording recording(folder.path() / "other.mcap"); });
  EXPECT_NE(said.find("is no recording of a run ("), std::string::npos) << said;
}

TEST(Recording, ASetupThatIsCutShortOrMissingIsToldWithTheFile) {
  const test::TemporaryFolder folder;
  const auto why = [&](std::size_t bytes_left_out) {
    McapWriter writer(folder.path() / "a.mcap", "ros2");
    writer.write(writer.add_channel("/amiss/setup", "cdr", "amiss_msgs/msg/Setup", "ros2msg", ""), {}, "1234");
    writer.close();
    const std::string whole = folder.read("a.mcap");
    folder.write("a.mcap", std::string_view(whole).substr(0, whole.size() - bytes_left_out));
    return test::sentence_of<InputError>([&] { Recording recording(folder.path() / "a.mcap"); });
  };
  EXPECT_NE(why(0).find("a.mcap: a message of the setup is cut short"), std::string::npos) << why(0);
  const std::size_t all_but_head = std::filesystem::file_size(folder.path() / "a.mcap") - 20;
  EXPECT_NE(why(all_but_head).find("or breaks off before it begins"), std::string::npos) << why(all_but_head);
}

TEST(Recording, AnObservationWithoutItsImagesIsRefusedWithItsTime) {
  const test::TemporaryFolder folder;
  McapWriter writer(folder.path() / "a.mcap", "ros2");
  const auto channel = [&](const char* topic, const char* type) {
    return writer.add_channel(topic, "cdr", type, "ros2msg", "");
  };
  writer.write(channel("/amiss/setup", "amiss_msgs/msg/Setup"), {}, setup_message({}));
  robot::Observation observation;
  observation.frame.emplace();
  writer.write(channel("/amiss/observation", "amiss_msgs/msg/Observation"), Stamp{std::chrono::seconds(3)},
               observation_message(observation));
  writer.close();
  Recording recording(folder.path() / "a.mcap");
  const std::string said = test::sentence_of<InputError>([&] { (void)recording.next(); });
  EXPECT_NE(said.find("a.mcap: /amiss/observation at 3"), std::string::npos) << said;
  EXPECT_NE(said.find("frame of an observation is missing"), std::string::npos) << said;
}

}  // namespace
}  // namespace amiss::recording
