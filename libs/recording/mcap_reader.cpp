#include "recording/mcap_reader.hpp"

#include <zlib.h>
#include <zstd.h>

#include "core/result.hpp"
#include "recording/internal/mcap_bytes.hpp"

namespace amiss::recording {

using namespace internal;

namespace {

constexpr std::uint64_t kMostBytes = std::uint64_t{1} << 30U;  // of a record or a chunk

std::uint32_t crc_of(std::string_view bytes) {
  return static_cast<std::uint32_t>(crc32_z(0, reinterpret_cast<const Bytef*>(bytes.data()), bytes.size()));
}

}  // namespace

McapReader::McapReader(const std::filesystem::path& file) : path_(file), file_(file, std::ios::binary) {
  std::error_code error;
  size_ = std::filesystem::is_regular_file(file, error) ? std::filesystem::file_size(file, error) : 0;
  if (!file_ || error) throw InputError(file.string() + ": there is no such file");
  std::string magic(kMagic.size(), '\0');
  file_.read(magic.data(), static_cast<std::streamsize>(magic.size()));
  if (magic != kMagic) throw InputError(file.string() + ": is no MCAP file (its first 8 bytes are others)");
}

McapReader::~McapReader() = default;

void McapReader::refuse(const std::string& what) const {
  throw InputError(path_.string() + ": record at byte " + std::to_string(at_) + ": " + what);
}

std::optional<McapMessage> McapReader::next() {
  while (true) {
    try {
      while (chunk_at_ < chunk_.size()) {
        Bytes bytes(std::string_view(chunk_).substr(chunk_at_));
        const auto op = static_cast<Op>(bytes.number<std::uint8_t>());
        const std::string_view content = bytes.take(bytes.number<std::uint64_t>());
        chunk_at_ += kRecordHead + content.size();
        if (op == Op::kSchema) read_schema(content);
        if (op == Op::kChannel) read_channel(content);
        if (op == Op::kMessage) return message_of(content);
      }
      if (!read_record()) return std::nullopt;
      const auto op = static_cast<Op>(op_);
      if (op == Op::kChunk) enter_chunk(record_);
      if (op == Op::kSchema) read_schema(record_);
      if (op == Op::kChannel) read_channel(record_);
      if (op == Op::kAttachment) read_attachment(record_);
      if (op == Op::kMessage) return message_of(record_);
      if (op == Op::kDataEnd) complete_ = true;
    } catch (const std::out_of_range&) {
      refuse("is shorter than what it says to hold");
    }
  }
}

bool McapReader::read_record() {
  if (complete_) return false;
  at_ = static_cast<std::uint64_t>(file_.tellg());
  std::string head(kRecordHead, '\0');
  if (at_ + head.size() > size_) return false;
  file_.read(head.data(), static_cast<std::streamsize>(head.size()));
  Bytes bytes(head);
  op_ = bytes.number<std::uint8_t>();
  const auto length = bytes.number<std::uint64_t>();
  if (length > size_ - at_ - head.size()) return false;  // breaks off here
  if (length > kMostBytes) refuse("holds more than 1 GB");
  record_.resize(length);
  file_.read(record_.data(), static_cast<std::streamsize>(length));
  if (!file_) refuse("cannot be read");
  return true;
}

void McapReader::enter_chunk(std::string_view content) {
  Bytes bytes(content);
  bytes.take(2 * sizeof(std::uint64_t));
  const auto size = bytes.number<std::uint64_t>();
  const auto crc = bytes.number<std::uint32_t>();
  const std::string compression(bytes.string());
  const std::string_view records = bytes.take(bytes.number<std::uint64_t>());
  if (size > kMostBytes) refuse("is a chunk of more than 1 GB");
  if (compression.empty()) {
    chunk_ = records;
  } else if (compression == "zstd") {
    chunk_.resize(size);
    const std::size_t got = ZSTD_decompress(chunk_.data(), chunk_.size(), records.data(), records.size());
    if (ZSTD_isError(got) != 0) refuse(std::string("zstd: ") + ZSTD_getErrorName(got));
    chunk_.resize(got);
  } else {
    refuse("is compressed by '" + compression + "'; zstd or nothing is allowed");
  }
  if (chunk_.size() != size) refuse("holds another number of bytes than it says");
  if (crc != 0 && crc != crc_of(chunk_)) refuse("its CRC differs: the file was damaged");
  chunk_at_ = 0;
}

void McapReader::read_schema(std::string_view content) {
  Bytes bytes(content);
  const auto id = bytes.number<std::uint16_t>();
  schemas_[id] = std::string(bytes.string());
}

void McapReader::read_channel(std::string_view content) {
  Bytes bytes(content);
  const auto id = bytes.number<std::uint16_t>();
  const auto schema = schemas_.find(bytes.number<std::uint16_t>());
  const std::string topic(bytes.string()), encoding(bytes.string());
  channels_[id] = {topic, encoding, schema == schemas_.end() ? "" : schema->second};
}

void McapReader::read_attachment(std::string_view content) {
  Bytes bytes(content);
  bytes.take(2 * sizeof(std::uint64_t));
  const std::string name(bytes.string());
  bytes.string();  // media type
  const std::string_view data = bytes.take(bytes.number<std::uint64_t>());
  const std::string_view covered = content.substr(0, content.size() - bytes.rest().size());
  const auto crc = bytes.number<std::uint32_t>();
  if (crc != 0 && crc != crc_of(covered)) refuse("attachment " + name + ": its CRC differs: the file was damaged");
  attachments_[name] = std::string(data);
}

McapMessage McapReader::message_of(std::string_view content) const {
  Bytes bytes(content);
  const auto channel = channels_.find(bytes.number<std::uint16_t>());
  if (channel == channels_.end()) refuse("is a message of a channel that was not told of");
  bytes.number<std::uint32_t>();  // sequence
  const Stamp stamp{std::chrono::nanoseconds(bytes.number<std::uint64_t>())};
  bytes.number<std::uint64_t>();  // published
  return {&channel->second, stamp, bytes.rest()};
}

}  // namespace amiss::recording
