#include <algorithm>
#include <charconv>
#include <cstring>

#include "core/result.hpp"
#include "dataset/cloud_files.hpp"
#include "dataset/internal/lzf.hpp"
#include "dataset/internal/records.hpp"
#include "dataset/internal/text.hpp"

namespace amiss::dataset {
namespace {

constexpr std::string_view kSignature = ".PCD";                // of the first line, which is a comment
constexpr std::size_t kMostFields = 200, kMostNumbers = 4096;  // of a field

struct Header {
  std::vector<std::string> names, types;
  std::vector<std::size_t> sizes, counts;
  std::size_t points = 0, width = 0, height = 1;
  bool has_points = false;
  std::string data;
  std::vector<std::string> notes;
  std::size_t end = 0;  // where the data begin
};

[[noreturn]] void refuse(const std::string& name, int line, const std::string& what) {
  throw InputError(name + ":" + std::to_string(line) + ": " + what);
}

std::vector<std::size_t> numbers(const std::vector<std::string_view>& words, const std::string& name, int line) {
  std::vector<std::size_t> values;
  for (std::size_t i = 1; i < words.size(); ++i) {
    std::size_t value = 0;
    const auto [end, error] = std::from_chars(words[i].data(), words[i].data() + words[i].size(), value);
    if (error != std::errc() || end != words[i].data() + words[i].size() || value > (std::size_t{1} << 32U)) {
      refuse(name, line, "'" + shown(words[i]) + "' is no number that can stand here");
    }
    values.push_back(value);
  }
  return values;
}

std::size_t one_number(const std::vector<std::string_view>& words, const std::string& name, int line) {
  const auto values = numbers(words, name, line);
  if (values.size() != 1) refuse(name, line, std::string(words[0]) + " needs one number");
  return values[0];
}

Header read_header(std::string_view bytes, const std::string& name) {
  Header h;
  LineReader lines(bytes);
  while (const auto line = lines.next()) {
    const auto words = words_of(*line);
    if (words.empty()) continue;
    if (words[0].starts_with('#')) {
      const std::string_view comment = line->substr(line->find('#') + 1);
      if (words.size() < 2 || words[1] != kSignature) keep_note(comment, h.notes);
      continue;
    }
    const int at = lines.line();
    if (words[0] == "FIELDS" || words[0] == "COLUMNS") {
      h.names.assign(words.begin() + 1, words.end());
    } else if (words[0] == "TYPE") {
      h.types.assign(words.begin() + 1, words.end());
    } else if (words[0] == "SIZE") {
      h.sizes = numbers(words, name, at);
    } else if (words[0] == "COUNT") {
      h.counts = numbers(words, name, at);
    } else if (words[0] == "WIDTH") {
      h.width = one_number(words, name, at);
    } else if (words[0] == "HEIGHT") {
      h.height = one_number(words, name, at);
    } else if (words[0] == "POINTS") {
      h.points = one_number(words, name, at);
      h.has_points = true;
    } else if (words[0] == "DATA") {
      h.data = words.size() == 2 ? std::string(words[1]) : std::string();
      if (h.data != "ascii" && h.data != "binary" && h.data != "binary_compressed") {
        refuse(name, at, "DATA must be ascii, binary or binary_compressed");
      }
      h.end = lines.position();
      return h;
    } else if (words[0] != "VERSION" && words[0] != "VIEWPOINT") {
      refuse(name, at, "'" + shown(words[0]) + "' is no entry of a PCD header");
    }
  }
  throw InputError(name + ": the header of a PCD file must end with DATA ascii, binary or binary_compressed");
}

Scalar scalar_of(const std::string& type, std::size_t size, const std::string& name) {
  const std::size_t exponent = size == 1 ? 0 : size == 2 ? 1 : size == 4 ? 2 : size == 8 ? 3 : 4;
  constexpr Scalar kSigned[] = {Scalar::kI8, Scalar::kI16, Scalar::kI32, Scalar::kI64};
  constexpr Scalar kUnsigned[] = {Scalar::kU8, Scalar::kU16, Scalar::kU32, Scalar::kU64};
  if (type == "F" && exponent == 2) return Scalar::kF32;
  if (type == "F" && exponent == 3) return Scalar::kF64;
  if (type == "I" && exponent < 4) return kSigned[exponent];
  if (type == "U" && exponent < 4) return kUnsigned[exponent];
  throw InputError(name + ": TYPE " + shown(type) + " with SIZE " + std::to_string(size) +
                   " is no number; F of 4 or 8, I and U of 1, 2, 4 or 8 bytes are allowed");
}

Records layout_of(const Header& h, const std::string& name) {
  const std::size_t n = h.names.size();
  if (n == 0 || n > kMostFields) throw InputError(name + ": FIELDS must name 1 to 200 fields");
  if (h.types.size() != n || h.sizes.size() != n || (!h.counts.empty() && h.counts.size() != n)) {
    throw InputError(name + ": FIELDS, SIZE, TYPE and COUNT must have equally many entries");
  }
  Records records;
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t count = h.counts.empty() ? 1 : h.counts[i];
    if (count == 0 || count > kMostNumbers) throw InputError(name + ": COUNT must lie in 1 .. 4096");
    records.add_field(h.names[i], scalar_of(h.types[i], h.sizes[i], name), count);
  }
  const std::size_t grid = h.width * h.height;
  if (h.width > 0 && grid / h.width != h.height) throw InputError(name + ": WIDTH times HEIGHT is too large");
  records.count = h.has_points ? h.points : grid;
  if (h.has_points && h.width > 0 && grid != h.points) {
    throw InputError(name + ": POINTS " + std::to_string(h.points) + " must be WIDTH times HEIGHT, " +
                     std::to_string(grid));
  }
  return records;
}

void read_ascii(std::string_view rest, Records& records, const std::string& name) {
  // A number takes two bytes at least.
  std::size_t words_a_point = 0;
  for (const Field& field : records.fields) words_a_point += field.count;
  if (records.count > rest.size() / (2 * words_a_point) + 1) {
    throw InputError(name + ": is too short for its " + std::to_string(records.count) + " points");
  }
  for (std::size_t i = 0; i < records.count; ++i) {
    for (const Field& field : records.fields) {
      for (std::size_t k = 0; k < field.count; ++k) {
        const std::string_view word = take_word(rest);
        if (!append_number(word, field.type, records.bytes)) {
          throw InputError(name + ": point " + std::to_string(i) + ": '" + shown(word) + "' is no number for " +
                           field.name);
        }
      }
    }
  }
}

void read_compressed(std::string_view rest, Records& records, const std::string& name) {
  const std::size_t whole = records.count * records.stride;
  std::uint32_t packed = 0, unpacked = 0;
  if (rest.size() < 8) throw InputError(name + ": ends before its compressed data begin");
  std::memcpy(&packed, rest.data(), 4);
  std::memcpy(&unpacked, rest.data() + 4, 4);
  if (unpacked != whole || packed > rest.size() - 8) {
    throw InputError(name + ": holds " + std::to_string(rest.size() - 8) + " bytes of compressed data for " +
                     std::to_string(unpacked) + "; its header promises " + std::to_string(whole));
  }
  const std::string fields = lzf_expanded(rest.substr(8, packed), whole, name);
  records.bytes.resize(whole);  // field after field -> point after point
  std::size_t from = 0;
  for (const Field& field : records.fields) {
    const std::size_t size = size_of(field.type) * field.count;
    for (std::size_t i = 0; i < records.count; ++i, from += size) {
      std::memcpy(records.bytes.data() + i * records.stride + field.offset, fields.data() + from, size);
    }
  }
}

void read_points(std::string_view rest, const Header& header, Records& records, const std::string& name) {
  if (header.data == "ascii") return read_ascii(rest, records, name);
  // LZF makes at most 264 bytes of 3.
  const std::size_t most = header.data == "binary" ? rest.size() : 100 * rest.size();
  if (records.count > most / records.stride) {
    throw InputError(name + ": is too short for its " + std::to_string(records.count) + " points of " +
                     std::to_string(records.stride) + " bytes");
  }
  if (header.data == "binary") {
    records.bytes = rest.substr(0, records.count * records.stride);
  } else if (records.count > 0) {
    read_compressed(rest, records, name);
  }
}

}  // namespace

CloudFile parse_pcd(std::string_view bytes, const std::string& name) {
  Header header = read_header(bytes, name);
  Records records = layout_of(header, name);
  read_points(bytes.substr(header.end), header, records, name);
  CloudFile file = cloud_of(records, name);
  file.notes = std::move(header.notes);
  return file;
}

std::string pcd_bytes(const CloudFile& cloud, CloudFormat format) {
  const Records records = records_of(cloud, ColourLayout::kPacked, "normal_");
  std::string names, sizes, types, counts;
  for (const Field& field : records.fields) {
    names += " " + field.name;
    sizes += " " + std::to_string(size_of(field.type));
    types += field.type == Scalar::kU32 ? " U" : " F";
    counts += " 1";
  }
  const std::string count = std::to_string(records.count);
  std::string bytes = "# .PCD v0.7 - Point Cloud Data file format\n" + note_lines(cloud, "#") + "VERSION 0.7\nFIELDS" +
                      names + "\nSIZE" + sizes + "\nTYPE" + types + "\nCOUNT" + counts + "\nWIDTH " + count +
                      "\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS " + count + "\nDATA ";
  return bytes + (format == CloudFormat::kAscii ? "ascii\n" + text_of(records) : "binary\n" + records.bytes);
}

}  // namespace amiss::dataset
