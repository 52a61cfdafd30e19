// Reads an MCAP file from front to back, with distrust: magic, lengths within the file, CRC of each chunk and
// attachment. A file that breaks off (a run that was killed) is read up to there.
//
// in: file with chunks that are uncompressed or zstd     out: messages in the order of the file
// InputError names file, place and what is wrong: no MCAP, a CRC that differs, another compression, a message without a
// channel, a chunk of more than 1 GB.
#pragma once

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "core/stamp.hpp"

namespace amiss::recording {

struct McapChannel {
  std::string topic, encoding, schema;  // schema: its name, as "sensor_msgs/msg/Image"
};

struct McapMessage {
  const McapChannel* channel = nullptr;  // lives as long as the reader
  Stamp stamp;
  std::string_view data;  // until the next call
};

class McapReader {
 public:
  explicit McapReader(const std::filesystem::path& file);
  ~McapReader();
  McapReader(const McapReader&) = delete;
  McapReader& operator=(const McapReader&) = delete;

  /// Nothing at the end.
  std::optional<McapMessage> next();
  /// Of those that were passed so far.
  [[nodiscard]] const std::map<std::string, std::string>& attachments() const { return attachments_; }
  /// At the end: did the file have its own end?
  [[nodiscard]] bool complete() const { return complete_; }

 private:
  bool read_record();  // of the file; false at its end
  void enter_chunk(std::string_view content);
  void read_schema(std::string_view content);
  void read_channel(std::string_view content);
  void read_attachment(std::string_view content);
  McapMessage message_of(std::string_view content) const;
  [[noreturn]] void refuse(const std::string& what) const;

  std::filesystem::path path_;
  std::ifstream file_;
  std::uint64_t size_ = 0, at_ = 0;  // at_: where the current record begins
  std::string record_, chunk_;
  std::size_t chunk_at_ = 0;
  std::uint8_t op_ = 0;
  std::map<std::uint16_t, std::string> schemas_;
  std::map<std::uint16_t, McapChannel> channels_;
  std::map<std::string, std::string> attachments_;
  bool complete_ = false;
};

}  // namespace amiss::recording
