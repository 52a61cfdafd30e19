// Writes an MCAP file (mcap.dev/spec, version 0): chunks compressed by zstd, each with its CRC and message indexes,
// then statistics and the indexes of chunks and attachments, CRC of data and of summary. What was flushed is in the
// file: a file that breaks off there is read up to there by every reader.
//
// in: schemas, channels, messages (stamp, bytes in the channel's encoding), attachments
// out: the file. std::runtime_error where it cannot be written. One thread at a time.
#pragma once

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "core/stamp.hpp"

namespace amiss::recording {

using ChannelId = std::uint16_t;

class McapWriter {
 public:
  McapWriter(const std::filesystem::path& file, std::string_view profile);
  ~McapWriter();
  McapWriter(const McapWriter&) = delete;
  McapWriter& operator=(const McapWriter&) = delete;

  /// A channel with its schema; a schema of the same name is shared.
  ChannelId add_channel(std::string_view topic, std::string_view message_encoding, std::string_view schema_name,
                        std::string_view schema_encoding, std::string_view schema);
  void write(ChannelId channel, Stamp stamp, std::string_view data);
  /// The messages so far as one chunk, handed to the operating system.
  void flush();
  /// Between chunks: what was written before is flushed.
  void attach(std::string_view name, std::string_view media_type, std::string_view data);
  /// Indexes and statistics; nothing comes after this.
  void close();

 private:
  struct ChunkIndex {
    std::uint64_t start_ns = 0, end_ns = 0, offset = 0, length = 0;
    std::map<ChannelId, std::uint64_t> index_offsets;
    std::uint64_t index_length = 0, compressed = 0, uncompressed = 0;
  };
  struct AttachmentIndex {
    std::uint64_t offset = 0, length = 0, data_size = 0;
    std::string name, media_type;
  };
  struct Entry {
    std::uint64_t stamp_ns, offset;
  };
  struct Compressor;

  void append(std::string_view bytes);
  void write_chunk_record(ChunkIndex& index);
  void write_message_indexes(ChunkIndex& index);
  [[nodiscard]] std::string statistics() const;
  [[nodiscard]] std::string summary(std::uint64_t begin, std::string& offsets) const;

  std::filesystem::path path_;
  std::ofstream file_;
  std::uint64_t written_ = 0;
  std::uint32_t crc_ = 0;  // of all bytes so far
  std::map<std::string, std::uint16_t, std::less<>> schema_ids_;
  std::vector<std::string> schemas_, channels_;  // their records
  std::size_t schemas_told_ = 0, channels_told_ = 0;
  std::string chunk_;
  std::unique_ptr<Compressor> compressor_;
  std::map<ChannelId, std::vector<Entry>> chunk_entries_;
  std::vector<ChunkIndex> chunks_;
  std::vector<AttachmentIndex> attachments_;
  std::map<ChannelId, std::uint64_t> counts_;
  std::uint64_t first_ns_ = 0, last_ns_ = 0;
  bool closed_ = false;
};

}  // namespace amiss::recording
