// From a cloud to records, and records as text.
#include <array>
#include <charconv>
#include <cmath>

#include "core/result.hpp"
#include "dataset/internal/records.hpp"

namespace amiss::dataset {
namespace {

template <class T>
void append(T value, std::string& bytes) {
  bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

/// Labels and the like are whole numbers and stay so; anything else is written as double, or float where that is
/// the same.
Scalar type_for(const ScalarField& field) {
  bool whole = true, single = true;
  for (const double v : field.values) {
    whole = whole && v >= 0.0 && v <= 4294967295.0 && v == std::floor(v);
    single = single && (std::isnan(v) || static_cast<double>(static_cast<float>(v)) == v);
  }
  if (whole) return Scalar::kU32;
  return single ? Scalar::kF32 : Scalar::kF64;
}

void append_scalar(double value, Scalar type, std::string& bytes) {
  if (type == Scalar::kU32) append(static_cast<std::uint32_t>(value), bytes);
  if (type == Scalar::kF32) append(static_cast<float>(value), bytes);
  if (type == Scalar::kF64) append(value, bytes);
}

void append_colour(Rgb c, ColourLayout layout, std::string& bytes) {
  if (layout == ColourLayout::kApart) {
    for (const std::uint8_t channel : {c.r, c.g, c.b}) append(channel, bytes);
  } else {
    append((std::uint32_t{c.r} << 16U) | (std::uint32_t{c.g} << 8U) | std::uint32_t{c.b}, bytes);
  }
}

void append_vector(const Eigen::Vector3f& v, std::string& bytes) {
  for (int axis = 0; axis < 3; ++axis) append(v[axis], bytes);
}

template <class T>
void append_text(T value, std::string& text) {
  std::array<char, 40> digits{};
  const auto written = std::to_chars(digits.data(), digits.data() + digits.size(), value);
  text.append(digits.data(), written.ptr);
}

}  // namespace

Records records_of(const CloudFile& file, ColourLayout layout, std::string_view normal_prefix) {
  const Cloud<Map>& cloud = file.cloud();
  Records records;
  for (const char* axis : {"x", "y", "z"}) records.add_field(axis, Scalar::kF32, 1);
  if (!cloud.colours.empty() && layout == ColourLayout::kPacked) records.add_field("rgb", Scalar::kU32, 1);
  if (!cloud.colours.empty() && layout == ColourLayout::kApart) {
    for (const char* channel : {"red", "green", "blue"}) records.add_field(channel, Scalar::kU8, 1);
  }
  if (!cloud.normals.empty()) {
    for (const char* axis : {"x", "y", "z"}) records.add_field(std::string(normal_prefix) + axis, Scalar::kF32, 1);
  }
  const std::size_t first_extra = records.fields.size();
  for (const ScalarField& field : file.fields) records.add_field(field.name, type_for(field), 1);
  records.count = cloud.points.size();
  records.bytes.reserve(records.count * records.stride);
  for (std::size_t i = 0; i < records.count; ++i) {
    append_vector(cloud.points[i], records.bytes);
    if (!cloud.colours.empty()) append_colour(cloud.colours[i], layout, records.bytes);
    if (!cloud.normals.empty()) append_vector(cloud.normals[i], records.bytes);
    for (std::size_t f = 0; f < file.fields.size(); ++f) {
      append_scalar(file.fields[f].values[i], records.fields[first_extra + f].type, records.bytes);
    }
  }
  return records;
}

std::string text_of(const Records& records) {
  std::string text;
  for (std::size_t i = 0; i < records.count; ++i) {
    const char* record = records.bytes.data() + i * records.stride;
    for (const Field& field : records.fields) {
      const double value = number_at(record + field.offset, field.type);
      if (field.offset > 0) text += ' ';
      if (field.type == Scalar::kF32) {
        append_text(static_cast<float>(value), text);
      } else if (field.type == Scalar::kF64) {
        append_text(value, text);
      } else {
        append_text(static_cast<std::int64_t>(value), text);
      }
    }
    text += '\n';
  }
  return text;
}

std::string note_lines(const CloudFile& cloud, const std::string& comment) {
  std::string lines;
  for (const std::string& note : cloud.notes) {
    lines += comment + " ";
    // A line of a header has no line in it.
    for (const char c : note) lines += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
    lines += "\n";
  }
  return lines;
}

void keep_note(std::string_view comment, std::vector<std::string>& notes) {
  constexpr std::size_t kMostNotes = 100, kLongestNote = 500;
  const std::size_t first = comment.find_first_not_of(" \t");
  if (first == comment.npos || notes.size() >= kMostNotes) return;
  const std::size_t last = comment.find_last_not_of(" \t");
  notes.emplace_back(comment.substr(first, std::min(last + 1 - first, kLongestNote)));
}

}  // namespace amiss::dataset
