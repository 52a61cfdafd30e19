// What is written is read back; the bytes that the specification fixes are where it wants them.
#include "recording/mcap_writer.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "core/random.hpp"
#include "core/temporary_folder.hpp"
#include "recording/mcap_reader.hpp"

namespace amiss::recording {
namespace {

using namespace std::chrono_literals;

struct Told {
  std::string topic, data;
  std::int64_t stamp_ns;
  bool operator==(const Told&) const = default;
};

std::vector<Told> read_all(McapReader& reader) {
  std::vector<Told> all;
  while (const auto m = reader.next()) {
    all.push_back({m->channel->topic, std::string(m->data), m->stamp.time_since_epoch().count()});
  }
  return all;
}

RC_GTEST_PROP(McapWriter, WhatIsWrittenIsReadBackInItsOrder, ()) {
  const test::TemporaryFolder folder;
  std::vector<Told> told;
  {
    McapWriter writer(folder.path() / "a.mcap", "ros2");
    const ChannelId channels[] = {writer.add_channel("/a", "cdr", "x/msg/A", "ros2msg", "int32 a\n"),
                                  writer.add_channel("/b", "cdr", "x/msg/A", "ros2msg", "int32 a\n")};
    for (int i = *rc::gen::inRange(0, 30); i > 0; --i) {
      const auto which = *rc::gen::inRange(0, 2);
      const auto data = *rc::gen::container<std::string>(rc::gen::arbitrary<char>());
      const std::int64_t ns = *rc::gen::inRange(0, 1000000);
      writer.write(channels[which], Stamp{std::chrono::nanoseconds(ns)}, data);
      told.push_back({which == 0 ? "/a" : "/b", data, ns});
      if (*rc::gen::inRange(0, 4) == 0) writer.flush();
    }
    writer.attach("note.txt", "text/plain", "told");
    writer.close();
  }
  McapReader reader(folder.path() / "a.mcap");
  RC_ASSERT(read_all(reader) == told);
  RC_ASSERT(reader.complete());
  RC_ASSERT(reader.attachments().at("note.txt") == "told");
}

TEST(McapWriter, BeginsAndEndsAsTheSpecificationSays) {
  const test::TemporaryFolder folder;
  McapWriter writer(folder.path() / "a.mcap", "ros2");
  writer.close();
  const std::string bytes = folder.read("a.mcap");
  const std::string magic("\x89MCAP0\r\n", 8);
  EXPECT_EQ(bytes.substr(0, 8), magic);
  EXPECT_EQ(bytes.substr(bytes.size() - 8), magic);
  EXPECT_EQ(bytes[8], '\x01') << "the header comes first";
  EXPECT_EQ(bytes.substr(17, 8), std::string("\x04\0\0\0ros2", 8));
  EXPECT_EQ(bytes[bytes.size() - 8 - 20 - 9], '\x02') << "the footer comes last: 9 bytes of head, 20 of content";
}

TEST(McapWriter, WhatWasFlushedIsThereWithoutAnEnd) {
  const test::TemporaryFolder folder;
  McapWriter writer(folder.path() / "a.mcap", "ros2");
  const ChannelId channel = writer.add_channel("/a", "cdr", "x/msg/A", "ros2msg", "int32 a\n");
  for (int second = 0; second < 3; ++second) {
    writer.write(channel, Stamp{std::chrono::seconds(second)}, "data");
    if (second < 2) writer.flush();
  }
  McapReader reader(folder.path() / "a.mcap");
  EXPECT_EQ(read_all(reader).size(), 2U);
  EXPECT_FALSE(reader.complete());
}

TEST(McapWriter, AFullDiskIsSaid) {
  if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "no /dev/full";
  McapWriter writer("/dev/full", "ros2");
  const ChannelId channel = writer.add_channel("/a", "cdr", "x/msg/A", "ros2msg", "int32 a\n");
  RandomStream random(1, "noise");
  std::string noise(1 << 20, ' ');
  for (char& c : noise) c = static_cast<char>(random.below(256));
  writer.write(channel, Stamp{}, noise);
  EXPECT_THROW(writer.flush(), std::runtime_error);
}

}  // namespace
}  // namespace amiss::recording
