#include <algorithm>
#include <charconv>

#include "core/result.hpp"
#include "dataset/cloud_files.hpp"
#include "dataset/internal/records.hpp"
#include "dataset/internal/text.hpp"

namespace amiss::dataset {
namespace {

constexpr std::size_t kMostProperties = 200;

struct Property {
  std::string name;
  Scalar type = Scalar::kF32;
  bool list = false;
  Scalar length_type = Scalar::kU8;
};
struct Element {
  std::string name;
  std::size_t count = 0;
  std::vector<Property> properties;
};
struct Header {
  enum class Format { kAscii, kLittle, kBig } format = Format::kAscii;
  std::vector<Element> elements;
  std::vector<std::string> notes;
  std::size_t end = 0;
};

[[noreturn]] void refuse(const std::string& name, int line, const std::string& what) {
  throw InputError(name + ":" + std::to_string(line) + ": " + what);
}

Scalar scalar_of(std::string_view word, const std::string& name, int line) {
  if (word == "char" || word == "int8") return Scalar::kI8;
  if (word == "uchar" || word == "uint8") return Scalar::kU8;
  if (word == "short" || word == "int16") return Scalar::kI16;
  if (word == "ushort" || word == "uint16") return Scalar::kU16;
  if (word == "int" || word == "int32") return Scalar::kI32;
  if (word == "uint" || word == "uint32") return Scalar::kU32;
  if (word == "float" || word == "float32") return Scalar::kF32;
  if (word == "double" || word == "float64") return Scalar::kF64;
  refuse(name, line, "'" + shown(word) + "' is no type; char, uchar, short, ushort, int, uint, float and double are");
}

Property property_of(const std::vector<std::string_view>& words, const std::string& name, int line) {
  if (words.size() == 5 && words[1] == "list") {
    return {std::string(words[4]), scalar_of(words[3], name, line), true, scalar_of(words[2], name, line)};
  }
  if (words.size() != 3) refuse(name, line, "a property is 'property TYPE NAME' or 'property list TYPE TYPE NAME'");
  return {std::string(words[2]), scalar_of(words[1], name, line), false, Scalar::kU8};
}

Element element_of(const std::vector<std::string_view>& words, const std::string& name, int line) {
  Element element;
  const auto last = words.size() == 3 ? words[2] : std::string_view();
  const auto [end, error] = std::from_chars(last.data(), last.data() + last.size(), element.count);
  if (last.empty() || error != std::errc() || end != last.data() + last.size()) {
    refuse(name, line, "an element is 'element NAME COUNT'");
  }
  element.name = words[1];
  return element;
}

Header::Format format_of(const std::vector<std::string_view>& words, const std::string& name, int line) {
  const auto word = words.size() == 3 ? words[1] : std::string_view();
  if (word == "ascii") return Header::Format::kAscii;
  if (word == "binary_little_endian") return Header::Format::kLittle;
  if (word == "binary_big_endian") return Header::Format::kBig;
  refuse(name, line, "format must be ascii, binary_little_endian or binary_big_endian, and 1.0");
}

Header read_header(std::string_view bytes, const std::string& name) {
  Header header;
  LineReader lines(bytes);
  const auto first = lines.next();
  if (!first || *first != "ply") throw InputError(name + ": the first line of a PLY file must be 'ply'");
  while (const auto line = lines.next()) {
    const auto words = words_of(*line);
    if (words.empty() || words[0] == "obj_info") continue;
    if (words[0] == "comment") {
      keep_note(line->substr(line->find(words[0]) + words[0].size()), header.notes);
      continue;
    }
    if (words[0] == "format") {
      header.format = format_of(words, name, lines.line());
    } else if (words[0] == "element") {
      header.elements.push_back(element_of(words, name, lines.line()));
    } else if (words[0] == "property") {
      if (header.elements.empty()) refuse(name, lines.line(), "a property before the first element");
      if (header.elements.back().properties.size() >= kMostProperties)
        refuse(name, lines.line(), "too many properties");
      header.elements.back().properties.push_back(property_of(words, name, lines.line()));
    } else if (words[0] == "end_header") {
      header.end = lines.position();
      return header;
    } else {
      refuse(name, lines.line(), "'" + shown(words[0]) + "' is no entry of a PLY header");
    }
  }
  throw InputError(name + ": the header of a PLY file must end with 'end_header'");
}

/// Numbers one after the other, whatever the format.
class Numbers {
 public:
  Numbers(std::string_view rest, Header::Format format, const std::string& name)
      : rest_(rest), format_(format), name_(name) {}

  /// Appends the next number little-endian.
  void take(Scalar type, std::string& bytes) {
    if (format_ == Header::Format::kAscii) {
      const std::string_view word = take_word(rest_);
      if (word.empty()) throw InputError(name_ + ": ends before all elements are there");
      if (!append_number(word, type, bytes)) {
        throw InputError(name_ + ": '" + shown(word) + "' is no number for its property");
      }
      return;
    }
    const std::size_t size = size_of(type);
    if (rest_.size() < size) throw InputError(name_ + ": ends before all elements are there");
    bytes.append(rest_.substr(0, size));
    if (format_ == Header::Format::kBig) std::reverse(bytes.end() - static_cast<std::ptrdiff_t>(size), bytes.end());
    rest_.remove_prefix(size);
  }
  double take_value(Scalar type) {
    one_.clear();
    take(type, one_);
    return number_at(one_.data(), type);
  }
  [[nodiscard]] std::size_t left() const { return rest_.size(); }
  void take_all(std::size_t size, std::string& bytes) {
    bytes.append(rest_.substr(0, size));
    rest_.remove_prefix(size);
  }

 private:
  std::string_view rest_;
  Header::Format format_;
  const std::string& name_;
  std::string one_;
};

/// Numbers of a list; what is no vertex index is taken and forgotten.
std::vector<double> take_list(Numbers& numbers, const Property& property, const std::string& name) {
  const double length = numbers.take_value(property.length_type);
  if (!(length >= 0.0 && length <= static_cast<double>(numbers.left()))) {
    throw InputError(name + ": a list of " + property.name + " is longer than the rest of the file");
  }
  std::vector<double> values(static_cast<std::size_t>(length));
  for (double& value : values) value = numbers.take_value(property.type);
  return values;
}

void check_count(const Element& element, std::size_t left, const std::string& name) {
  // Every number takes one byte at least.
  if (element.count > left / std::max<std::size_t>(1, element.properties.size()) + 1) {
    throw InputError(name + ": is too short for its " + std::to_string(element.count) + " elements '" + element.name +
                     "'");
  }
}

Records take_vertices(Numbers& numbers, const Element& element, Header::Format format, const std::string& name) {
  Records records;
  bool lists = false;
  for (const Property& property : element.properties) {
    lists = lists || property.list;
    if (!property.list) records.add_field(property.name, property.type, 1);
  }
  records.count = element.count;
  if (format == Header::Format::kLittle && !lists) {
    const std::size_t whole = records.count * records.stride;
    if (whole > numbers.left()) throw InputError(name + ": ends before all vertices are there");
    numbers.take_all(whole, records.bytes);
    return records;
  }
  for (std::size_t i = 0; i < element.count; ++i) {
    for (const Property& property : element.properties) {
      if (property.list) {
        (void)take_list(numbers, property, name);
      } else {
        numbers.take(property.type, records.bytes);
      }
    }
  }
  return records;
}

void take_faces(Numbers& numbers, const Element& element, const std::string& name,
                std::vector<std::array<std::uint32_t, 3>>& triangles) {
  for (std::size_t i = 0; i < element.count; ++i) {
    for (const Property& property : element.properties) {
      if (!property.list) {
        (void)numbers.take_value(property.type);
        continue;
      }
      const std::vector<double> corners = take_list(numbers, property, name);
      if (property.name != "vertex_indices" && property.name != "vertex_index") continue;
      const auto index = [&](std::size_t k) {
        if (!(corners[k] >= 0.0 && corners[k] <= 4294967295.0))
          throw InputError(name + ": a face with an index below 0");
        return static_cast<std::uint32_t>(corners[k]);
      };
      for (std::size_t k = 2; k < corners.size(); ++k) triangles.push_back({index(0), index(k - 1), index(k)});
    }
  }
}

}  // namespace

CloudFile parse_ply(std::string_view bytes, const std::string& name) {
  Header header = read_header(bytes, name);
  Numbers numbers(bytes.substr(header.end), header.format, name);
  CloudFile file;
  bool vertices = false;
  std::vector<std::array<std::uint32_t, 3>> triangles, ignored;
  for (const Element& element : header.elements) {
    if (element.properties.empty()) continue;
    check_count(element, numbers.left(), name);
    if (element.name == "vertex" && !vertices) {
      file = cloud_of(take_vertices(numbers, element, header.format, name), name);
      vertices = true;
    } else {
      take_faces(numbers, element, name, element.name == "face" ? triangles : ignored);
    }
  }
  if (!vertices) throw InputError(name + ": has no element 'vertex'");
  for (const auto& triangle : triangles) {
    for (const std::uint32_t corner : triangle) {
      if (corner >= file.cloud().points.size()) {
        throw InputError(name + ": a face names vertex " + std::to_string(corner) + " of " +
                         std::to_string(file.cloud().points.size()));
      }
    }
  }
  file.mesh.triangles = std::move(triangles);
  file.notes = std::move(header.notes);
  return file;
}

std::string ply_bytes(const CloudFile& cloud, CloudFormat format) {
  const bool ascii = format == CloudFormat::kAscii;
  const Records records = records_of(cloud, ColourLayout::kApart, "n");
  std::string bytes = std::string("ply\nformat ") + (ascii ? "ascii" : "binary_little_endian") + " 1.0\n" +
                      note_lines(cloud, "comment") + "element vertex " + std::to_string(records.count) + "\n";
  for (const Field& field : records.fields) {
    const char* type = field.type == Scalar::kU8    ? "uchar"
                       : field.type == Scalar::kU32 ? "uint"
                       : field.type == Scalar::kF32 ? "float"
                                                    : "double";
    bytes += std::string("property ") + type + " " + field.name + "\n";
  }
  const auto& triangles = cloud.mesh.triangles;
  if (!triangles.empty()) {
    bytes += "element face " + std::to_string(triangles.size()) + "\nproperty list uchar int vertex_indices\n";
  }
  bytes += "end_header\n" + (ascii ? text_of(records) : records.bytes);
  for (const auto& t : triangles) {
    if (ascii) {
      bytes += "3 " + std::to_string(t[0]) + " " + std::to_string(t[1]) + " " + std::to_string(t[2]) + "\n";
    } else {
      bytes += '\3';
      bytes.append(reinterpret_cast<const char*>(t.data()), sizeof t);
    }
  }
  return bytes;
}

}  // namespace amiss::dataset
