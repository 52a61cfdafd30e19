#include "recording/mcap_writer.hpp"

#include <libdeflate.h>
#include <zstd.h>

#include <algorithm>
#include <stdexcept>

#include "recording/internal/mcap_bytes.hpp"

namespace amiss::recording {

using namespace internal;

namespace {

constexpr const char* kCompression = "zstd";
constexpr int kLevel = 1;

std::uint32_t crc_of(std::string_view bytes, std::uint32_t so_far = 0) {
  return libdeflate_crc32(so_far, bytes.data(), bytes.size());  // half of zlib's time
}

std::uint64_t ns_of(Stamp stamp) { return static_cast<std::uint64_t>(stamp.time_since_epoch().count()); }

void put_counts(std::string& out, const std::map<ChannelId, std::uint64_t>& counts) {
  put(out, static_cast<std::uint32_t>(counts.size() * (sizeof(ChannelId) + sizeof(std::uint64_t))));
  for (const auto& [channel, count] : counts) {
    put(out, channel);
    put(out, count);
  }
}

}  // namespace

/// Its memory serves one chunk after the other.
struct McapWriter::Compressor {
  /// Until the next call.
  std::string_view compressed(std::string_view bytes) {
    if (const std::size_t most = ZSTD_compressBound(bytes.size()); most > room.size()) room.resize(most);
    const std::size_t size =
        ZSTD_compressCCtx(context.get(), room.data(), room.size(), bytes.data(), bytes.size(), kLevel);
    if (ZSTD_isError(size) != 0) throw std::runtime_error(std::string("zstd: ") + ZSTD_getErrorName(size));
    return {room.data(), size};
  }

  std::unique_ptr<ZSTD_CCtx, decltype(&ZSTD_freeCCtx)> context{ZSTD_createCCtx(), &ZSTD_freeCCtx};
  std::string room;
};

McapWriter::McapWriter(const std::filesystem::path& file, std::string_view profile)
    : path_(file), file_(file, std::ios::binary | std::ios::trunc), compressor_(std::make_unique<Compressor>()) {
  if (!file_) throw std::runtime_error(file.string() + ": cannot be written");
  std::string head(kMagic), content;
  put_string(content, profile);
  put_string(content, "amiss");
  put_record(head, Op::kHeader, content);
  append(head);
}

McapWriter::~McapWriter() = default;

ChannelId McapWriter::add_channel(std::string_view topic, std::string_view message_encoding,
                                  std::string_view schema_name, std::string_view schema_encoding,
                                  std::string_view schema) {
  auto known = schema_ids_.find(schema_name);
  if (known == schema_ids_.end()) {
    known = schema_ids_.emplace(schema_name, static_cast<std::uint16_t>(schemas_.size() + 1)).first;
    std::string content;
    put(content, known->second);
    put_string(content, schema_name);
    put_string(content, schema_encoding);
    put_string(content, schema);
    put_record(schemas_.emplace_back(), Op::kSchema, content);
  }
  const auto id = static_cast<ChannelId>(channels_.size());
  std::string content;
  put(content, id);
  put(content, known->second);
  put_string(content, topic);
  put_string(content, message_encoding);
  put(content, std::uint32_t{0});  // metadata
  put_record(channels_.emplace_back(), Op::kChannel, content);
  return id;
}

void McapWriter::write(ChannelId channel, Stamp stamp, std::string_view data) {
  for (; schemas_told_ < schemas_.size(); ++schemas_told_) chunk_ += schemas_[schemas_told_];
  for (; channels_told_ < channels_.size(); ++channels_told_) chunk_ += channels_[channels_told_];
  const std::uint64_t stamp_ns = ns_of(stamp);
  chunk_entries_[channel].push_back({stamp_ns, chunk_.size()});
  std::string head;
  put(head, channel);
  put(head, static_cast<std::uint32_t>(counts_[channel]++));
  put(head, stamp_ns);  // logged
  put(head, stamp_ns);  // published
  put(chunk_, static_cast<std::uint8_t>(Op::kMessage));
  put(chunk_, static_cast<std::uint64_t>(head.size() + data.size()));
  chunk_.append(head).append(data);
}

void McapWriter::flush() {
  if (chunk_entries_.empty()) return;
  ChunkIndex index;
  index.start_ns = ~std::uint64_t{0};
  for (auto& [channel, entries] : chunk_entries_) {
    std::stable_sort(entries.begin(), entries.end(),
                     [](const Entry& a, const Entry& b) { return a.stamp_ns < b.stamp_ns; });
    index.start_ns = std::min(index.start_ns, entries.front().stamp_ns);
    index.end_ns = std::max(index.end_ns, entries.back().stamp_ns);
  }
  first_ns_ = chunks_.empty() ? index.start_ns : std::min(first_ns_, index.start_ns);
  last_ns_ = std::max(last_ns_, index.end_ns);
  write_chunk_record(index);
  write_message_indexes(index);
  chunks_.push_back(std::move(index));
  chunk_.clear();
  chunk_entries_.clear();
  file_.flush();
  if (!file_) throw std::runtime_error(path_.string() + ": cannot be written");
}

void McapWriter::write_chunk_record(ChunkIndex& index) {
  const std::string_view records = compressor_->compressed(chunk_);
  std::string content, head;
  put(content, index.start_ns);
  put(content, index.end_ns);
  put(content, static_cast<std::uint64_t>(chunk_.size()));
  put(content, crc_of(chunk_));
  put_string(content, kCompression);
  put(content, static_cast<std::uint64_t>(records.size()));
  put(head, static_cast<std::uint8_t>(Op::kChunk));
  put(head, static_cast<std::uint64_t>(content.size() + records.size()));
  index.offset = written_;
  index.length = head.size() + content.size() + records.size();
  index.compressed = records.size();
  index.uncompressed = chunk_.size();
  append(head + content);
  append(records);
}

void McapWriter::write_message_indexes(ChunkIndex& index) {
  const std::uint64_t begin = written_;
  for (const auto& [channel, entries] : chunk_entries_) {
    std::string content, record;
    put(content, channel);
    put(content, static_cast<std::uint32_t>(entries.size() * sizeof(Entry)));
    for (const Entry& entry : entries) {
      put(content, entry.stamp_ns);
      put(content, entry.offset);
    }
    put_record(record, Op::kMessageIndex, content);
    index.index_offsets[channel] = written_;
    append(record);
  }
  index.index_length = written_ - begin;
}

void McapWriter::attach(std::string_view name, std::string_view media_type, std::string_view data) {
  flush();
  std::string content;
  put(content, std::uint64_t{0});  // logged and made: no wall clock
  put(content, std::uint64_t{0});
  put_string(content, name);
  put_string(content, media_type);
  put(content, static_cast<std::uint64_t>(data.size()));
  content += data;
  put(content, crc_of(content));
  std::string record;
  put_record(record, Op::kAttachment, content);
  attachments_.push_back({written_, record.size(), data.size(), std::string(name), std::string(media_type)});
  append(record);
}

std::string McapWriter::statistics() const {
  std::uint64_t messages = 0;
  for (const auto& [channel, count] : counts_) messages += count;
  std::string content;
  put(content, messages);
  put(content, static_cast<std::uint16_t>(schemas_.size()));
  put(content, static_cast<std::uint32_t>(channels_.size()));
  put(content, static_cast<std::uint32_t>(attachments_.size()));
  put(content, std::uint32_t{0});  // metadata
  put(content, static_cast<std::uint32_t>(chunks_.size()));
  put(content, first_ns_);
  put(content, last_ns_);
  put_counts(content, counts_);
  return content;
}

/// Schemas, channels, statistics, indexes; `offsets` gets where each group is, for a summary that begins at `begin`.
std::string McapWriter::summary(std::uint64_t begin, std::string& offsets) const {
  std::string out;
  const auto group = [&](Op op, const auto& write_all) {
    const std::size_t start = out.size();
    write_all();
    if (out.size() == start) return;
    std::string content;
    put(content, static_cast<std::uint8_t>(op));
    put(content, begin + start);
    put(content, static_cast<std::uint64_t>(out.size() - start));
    put_record(offsets, Op::kSummaryOffset, content);
  };
  group(Op::kSchema, [&] {
    for (const std::string& record : schemas_) out += record;
  });
  group(Op::kChannel, [&] {
    for (const std::string& record : channels_) out += record;
  });
  group(Op::kStatistics, [&] { put_record(out, Op::kStatistics, statistics()); });
  group(Op::kChunkIndex, [&] {
    for (const ChunkIndex& c : chunks_) {
      std::string content;
      for (const std::uint64_t value : {c.start_ns, c.end_ns, c.offset, c.length}) put(content, value);
      put_counts(content, c.index_offsets);
      put(content, c.index_length);
      put_string(content, kCompression);
      put(content, c.compressed);
      put(content, c.uncompressed);
      put_record(out, Op::kChunkIndex, content);
    }
  });
  group(Op::kAttachmentIndex, [&] {
    for (const AttachmentIndex& a : attachments_) {
      std::string content;
      for (const std::uint64_t value : {a.offset, a.length, std::uint64_t{0}, std::uint64_t{0}, a.data_size})
        put(content, value);
      put_string(content, a.name);
      put_string(content, a.media_type);
      put_record(out, Op::kAttachmentIndex, content);
    }
  });
  return out;
}

void McapWriter::close() {
  if (closed_) return;
  closed_ = true;
  flush();
  std::string end, content;
  put(content, crc_);
  put_record(end, Op::kDataEnd, content);
  append(end);
  const std::uint64_t begin = written_;
  std::string offsets, tail = summary(begin, offsets);
  const std::uint64_t offsets_begin = begin + tail.size();
  tail += offsets;
  put(tail, static_cast<std::uint8_t>(Op::kFooter));
  put(tail, static_cast<std::uint64_t>(2 * sizeof(std::uint64_t) + sizeof(std::uint32_t)));
  put(tail, begin);
  put(tail, offsets_begin);
  put(tail, crc_of(tail));
  tail += kMagic;
  append(tail);
  file_.close();
  if (!file_) throw std::runtime_error(path_.string() + ": cannot be written");
}

void McapWriter::append(std::string_view bytes) {
  file_.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  if (!file_) throw std::runtime_error(path_.string() + ": cannot be written");
  crc_ = crc_of(bytes, crc_);
  written_ += bytes.size();
}

}  // namespace amiss::recording
