#include "recording/mcap_reader.hpp"

#include <gtest/gtest.h>

#include "core/random.hpp"
#include "core/result.hpp"
#include "core/temporary_folder.hpp"
#include "recording/mcap_writer.hpp"

namespace amiss::recording {
namespace {

/// Two chunks of 20 messages and an attachment between them.
std::string small_file(const test::TemporaryFolder& folder) {
  McapWriter writer(folder.path() / "small.mcap", "ros2");
  const ChannelId channel = writer.add_channel("/a", "cdr", "x/msg/A", "ros2msg", "int32 a\n");
  for (int i = 0; i < 40; ++i) {
    if (i == 20) writer.attach("note.txt", "text/plain", std::string(300, 'n'));
    writer.write(channel, Stamp{std::chrono::milliseconds(i)}, std::string(100, static_cast<char>('a' + i % 20)));
  }
  writer.close();
  return folder.read("small.mcap");
}

/// Messages until the end or a refusal.
std::size_t count_messages(const std::filesystem::path& file) {
  McapReader reader(file);
  std::size_t messages = 0;
  while (reader.next()) ++messages;
  return messages;
}

TEST(McapReader, AnyFrontPartIsReadUpToItsLastWholeChunk) {
  const test::TemporaryFolder folder;
  const std::string whole = small_file(folder);
  for (std::size_t size = 8; size < whole.size(); size += 7) {
    const std::size_t messages = count_messages(folder.write("cut.mcap", whole.substr(0, size)));
    EXPECT_TRUE(messages == 0 || messages == 20 || messages == 40) << size;
  }
}

TEST(McapReader, ADamagedByteOfAChunkOrAnAttachmentIsRefusedOrChangesNothing) {
  const test::TemporaryFolder folder;
  const std::string whole = small_file(folder);
  RandomStream random(1, "damage");
  int refused = 0;
  for (int i = 0; i < 300; ++i) {
    std::string damaged = whole;
    damaged[8 + random.below(static_cast<std::uint32_t>(whole.size() - 8))] ^= static_cast<char>(1 + random.below(255));
    try {
      EXPECT_LE(count_messages(folder.write("damaged.mcap", damaged)), 40U);
    } catch (const InputError& e) {
      EXPECT_NE(std::string(e.what()).find("damaged.mcap"), std::string::npos);
      ++refused;
    }
  }
  EXPECT_GT(refused, 50);
}

TEST(McapReader, OtherFilesAreRefused) {
  const test::TemporaryFolder folder;
  const auto said = [&](const std::string& bytes) {
    return test::sentence_of<InputError>([&] { McapReader reader(folder.write("x.mcap", bytes)); });
  };
  EXPECT_NE(said("").find("is no MCAP file"), std::string::npos);
  EXPECT_NE(said("#!/bin/sh\necho no\n").find("is no MCAP file"), std::string::npos);
  EXPECT_NE(test::sentence_of<InputError>([&] { McapReader reader(folder.path() / "none.mcap"); }).find("no such file"),
            std::string::npos);
}

}  // namespace
}  // namespace amiss::recording
