#include "dataset/internal/bag_file.hpp"

#include <fstream>

#include "core/result.hpp"
#include "dataset/internal/bag_chunk.hpp"
#include "dataset/internal/bytes.hpp"

namespace amiss::dataset {
namespace {

constexpr std::string_view kMagic = "#ROSBAG V2.0\n";
constexpr std::size_t kMostHeader = std::size_t{1} << 20U, kMostChunk = std::size_t{1} << 28U;
constexpr char kMessage = 2, kChunk = 5, kConnection = 7;

/// The fields "name=value" of a record's header.
std::map<std::string, std::string, std::less<>> fields_of(std::string_view bytes, const std::string& name) {
  std::map<std::string, std::string, std::less<>> fields;
  ByteReader reader(bytes, name);
  while (!reader.at_end()) {
    const std::string_view field = reader.counted();
    const std::size_t equals = field.find('=');
    if (equals == std::string_view::npos) throw InputError(name + ": a field of a record has no '='");
    fields.emplace(field.substr(0, equals), field.substr(equals + 1));
  }
  return fields;
}

struct Header {
  std::map<std::string, std::string, std::less<>> fields;
  std::string name;

  [[nodiscard]] const std::string& text(std::string_view field) const {
    const auto found = fields.find(field);
    if (found == fields.end()) throw InputError(name + ": a record has no field '" + std::string(field) + "'");
    return found->second;
  }
  [[nodiscard]] std::uint32_t number(std::string_view field) const {
    return ByteReader(text(field), name).get<std::uint32_t>();
  }
  [[nodiscard]] char op() const { return ByteReader(text("op"), name).get<char>(); }
};

/// The file, forwards.
class RecordReader {
 public:
  RecordReader(const std::filesystem::path& file, std::uint64_t at)
      : name_(file.string()), stream_(file, std::ios::binary), at_(at), size_(std::filesystem::file_size(file)) {
    stream_.seekg(static_cast<std::streamoff>(at));
    if (!stream_) throw InputError(name_ + ": cannot be read");
  }
  [[nodiscard]] std::uint64_t at() const { return at_; }
  [[nodiscard]] bool at_end() const { return at_ >= size_; }
  [[nodiscard]] std::uint64_t left() const { return size_ - at_; }
  std::uint32_t length(std::size_t most) {
    const std::string bytes = take(4);
    const auto value = ByteReader(bytes, name_).get<std::uint32_t>();
    const std::string where = "at byte " + std::to_string(at_ - 4) + " a length of " + std::to_string(value);
    if (value > left()) throw InputError(name_ + ": ends in the middle of a record (" + where + " leads out of it)");
    if (value > most) throw InputError(name_ + ": " + where + " is no sensible one");
    return value;
  }
  std::string take(std::size_t count) {
    if (count > left()) throw InputError(name_ + ": ends in the middle of a record");
    std::string bytes(count, '\0');
    stream_.read(bytes.data(), static_cast<std::streamsize>(count));
    if (!stream_) throw InputError(name_ + ": cannot be read");
    at_ += count;
    return bytes;
  }
  void skip(std::uint64_t count) {
    at_ += count;
    stream_.seekg(static_cast<std::streamoff>(at_));
  }
  Header header() { return {fields_of(take(length(kMostHeader)), name_), name_}; }

 private:
  std::string name_;
  std::ifstream stream_;
  std::uint64_t at_, size_;
};

using Connections = std::map<std::uint32_t, BagConnection>;

void add_connection(const Header& header, std::string_view data, Connections& connections) {
  const auto inner = fields_of(data, header.name);
  const auto type = inner.find("type");
  if (type == inner.end()) throw InputError(header.name + ": a connection has no type");
  connections[header.number("conn")] = {header.text("topic"), type->second};
}

const BagConnection& connection_of(const Header& header, const Connections& connections) {
  const auto found = connections.find(header.number("conn"));
  if (found == connections.end()) throw InputError(header.name + ": a message comes before its connection");
  return found->second;
}

void visit_chunk(const std::string& chunk, std::uint64_t place, const std::string& name, Connections& connections,
                 const BagFile::Visitor& visit) {
  ByteReader reader(chunk, name);
  while (!reader.at_end()) {
    const Header header{fields_of(reader.counted(), name), name};
    const std::string_view data = reader.counted();
    if (header.op() == kConnection) add_connection(header, data, connections);
    if (header.op() != kMessage) continue;
    const std::uint64_t at = chunk.size() - reader.left() - data.size();
    visit(connection_of(header, connections), {place, at, data.size(), true}, data);
  }
}

std::string read_chunk(RecordReader& records, const Header& header) {
  const std::size_t size = header.number("size");
  if (size > kMostChunk) throw InputError(header.name + ": a chunk of " + std::to_string(size) + " bytes is too large");
  return chunk_expanded(records.take(records.length(kMostChunk)), header.text("compression"), size, header.name);
}

}  // namespace

BagFile::BagFile(std::filesystem::path file) : file_(std::move(file)) {
  if (!is_bag(file_)) throw InputError(file_.string() + ": is no ROS 1 bag of format 2.0");
}

bool BagFile::is_bag(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::string begin(kMagic.size(), '\0');
  stream.read(begin.data(), static_cast<std::streamsize>(begin.size()));
  return stream && begin == kMagic;
}

void BagFile::each(const Visitor& visit) const {
  const std::string name = file_.string();
  RecordReader records(file_, kMagic.size());
  Connections connections;
  while (!records.at_end()) {
    const std::uint64_t place = records.at();
    const Header header = records.header();
    if (header.op() == kChunk) {
      visit_chunk(read_chunk(records, header), place, name, connections, visit);
      continue;
    }
    const std::uint32_t size = records.length(std::numeric_limits<std::uint32_t>::max());
    const std::uint64_t at = records.at();
    if (header.op() == kConnection) {
      add_connection(header, records.take(size), connections);
    } else if (header.op() == kMessage) {
      visit(connection_of(header, connections), {place, at, size, false}, records.take(size));
    } else {
      records.skip(size);
    }
  }
}

std::string BagFile::read(const BagPlace& place) const {
  if (!place.in_chunk) return RecordReader(file_, place.at).take(place.size);
  return chunk(place.chunk).substr(place.at, place.size);
}

std::string BagFile::chunk(std::uint64_t at) const {
  RecordReader records(file_, at);
  const Header header = records.header();
  return read_chunk(records, header);
}

}  // namespace amiss::dataset
