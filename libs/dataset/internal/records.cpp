#include "dataset/internal/records.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstring>

#include "core/result.hpp"

namespace amiss::dataset {
namespace {

static_assert(std::endian::native == std::endian::little);

template <class T>
T read(const char* at) {
  T value;
  std::memcpy(&value, at, sizeof value);
  return value;
}
template <class T>
void append(T value, std::string& bytes) {
  bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}
template <class T>
bool append_integer(std::string_view text, std::string& bytes) {
  T value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error == std::errc() && end == text.data() + text.size()) {
    append(value, bytes);
    return true;
  }
  // "3.0" where an integer should stand is written by some.
  double number = 0.0;
  const auto [end_of_number, no_number] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (no_number != std::errc() || end_of_number != text.data() + text.size()) return false;
  if (!(number >= static_cast<double>(std::numeric_limits<T>::min()) && number <= 9e15 &&
        number <= static_cast<double>(std::numeric_limits<T>::max())) ||
      number != std::floor(number)) {
    return false;
  }
  append(static_cast<T>(number), bytes);
  return true;
}

const Field* find(const Records& records, std::initializer_list<const char*> names) {
  for (const char* name : names) {
    for (const Field& field : records.fields) {
      if (field.count == 1 && field.name == name) return &field;
    }
  }
  return nullptr;
}

/// The reader of one field over all records.
class Column {
 public:
  Column(const Records& records, const Field& field)
      : at_(records.bytes.data() + field.offset), stride_(records.stride), type_(field.type) {}
  [[nodiscard]] double number(std::size_t i) const { return number_at(at_ + i * stride_, type_); }
  [[nodiscard]] std::uint32_t bits(std::size_t i) const { return read<std::uint32_t>(at_ + i * stride_); }
  /// 0 .. 255; numbers with a fraction are parts of 1.
  [[nodiscard]] std::uint8_t channel(std::size_t i) const {
    const bool real = type_ == Scalar::kF32 || type_ == Scalar::kF64;
    const double value = real ? 255.0 * number(i) : number(i);
    return static_cast<std::uint8_t>(std::isfinite(value) ? std::clamp(std::round(value), 0.0, 255.0) : 0.0);
  }

 private:
  const char* at_;
  std::size_t stride_;
  Scalar type_;
};

std::vector<Eigen::Vector3f> vectors_of(const Records& records, const std::array<const Field*, 3>& fields) {
  std::vector<Eigen::Vector3f> vectors(records.count);
  for (int axis = 0; axis < 3; ++axis) {
    const Column column(records, *fields[static_cast<std::size_t>(axis)]);
    for (std::size_t i = 0; i < records.count; ++i) vectors[i][axis] = static_cast<float>(column.number(i));
  }
  return vectors;
}

std::vector<Rgb> packed_colours(const Records& records, const Field& field) {
  std::vector<Rgb> colours(records.count);
  const Column column(records, field);
  for (std::size_t i = 0; i < records.count; ++i) {
    const std::uint32_t bits = column.bits(i);
    colours[i] = {static_cast<std::uint8_t>(bits >> 16U), static_cast<std::uint8_t>(bits >> 8U),
                  static_cast<std::uint8_t>(bits)};
  }
  return colours;
}

std::vector<Rgb> apart_colours(const Records& records, const std::array<const Field*, 3>& fields) {
  std::vector<Rgb> colours(records.count);
  const Column r(records, *fields[0]), g(records, *fields[1]), b(records, *fields[2]);
  for (std::size_t i = 0; i < records.count; ++i) colours[i] = {r.channel(i), g.channel(i), b.channel(i)};
  return colours;
}

bool all_there(const std::array<const Field*, 3>& fields) {
  return std::none_of(fields.begin(), fields.end(), [](const Field* f) { return f == nullptr; });
}

}  // namespace

std::size_t size_of(Scalar type) {
  constexpr std::array<std::size_t, 10> kSizes{1, 1, 2, 2, 4, 4, 8, 8, 4, 8};
  return kSizes[static_cast<std::size_t>(type)];
}

void Records::add_field(std::string name, Scalar type, std::size_t number) {
  fields.push_back({std::move(name), type, number, stride});
  stride += size_of(type) * number;
}

bool append_number(std::string_view text, Scalar type, std::string& bytes) {
  if (text.starts_with('+')) text.remove_prefix(1);
  switch (type) {
    case Scalar::kI8:
      return append_integer<std::int8_t>(text, bytes);
    case Scalar::kU8:
      return append_integer<std::uint8_t>(text, bytes);
    case Scalar::kI16:
      return append_integer<std::int16_t>(text, bytes);
    case Scalar::kU16:
      return append_integer<std::uint16_t>(text, bytes);
    case Scalar::kI32:
      return append_integer<std::int32_t>(text, bytes);
    case Scalar::kU32:
      return append_integer<std::uint32_t>(text, bytes);
    case Scalar::kI64:
      return append_integer<std::int64_t>(text, bytes);
    case Scalar::kU64:
      return append_integer<std::uint64_t>(text, bytes);
    case Scalar::kF32:
    case Scalar::kF64:
      break;
  }
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error == std::errc::invalid_argument || end != text.data() + text.size()) return false;
  if (error == std::errc::result_out_of_range) value = 0.0;  // 1e-400 and its like
  if (type == Scalar::kF64) append(value, bytes);
  if (type == Scalar::kF32) append(static_cast<float>(value), bytes);
  return true;
}

double number_at(const char* at, Scalar type) {
  switch (type) {
    case Scalar::kI8:
      return read<std::int8_t>(at);
    case Scalar::kU8:
      return read<std::uint8_t>(at);
    case Scalar::kI16:
      return read<std::int16_t>(at);
    case Scalar::kU16:
      return read<std::uint16_t>(at);
    case Scalar::kI32:
      return read<std::int32_t>(at);
    case Scalar::kU32:
      return read<std::uint32_t>(at);
    case Scalar::kI64:
      return static_cast<double>(read<std::int64_t>(at));
    case Scalar::kU64:
      return static_cast<double>(read<std::uint64_t>(at));
    case Scalar::kF32:
      return static_cast<double>(read<float>(at));
    case Scalar::kF64:
      break;
  }
  return read<double>(at);
}

CloudFile cloud_of(const Records& records, const std::string& name) {
  const std::array places{find(records, {"x"}), find(records, {"y"}), find(records, {"z"})};
  if (!all_there(places)) throw InputError(name + ": has no fields x, y and z; a cloud needs the three");
  CloudFile file;
  Cloud<Map>& cloud = file.mesh.vertices;
  std::vector<const Field*> used(places.begin(), places.end());
  cloud.points = vectors_of(records, places);
  const std::array normals{find(records, {"normal_x", "nx"}), find(records, {"normal_y", "ny"}),
                           find(records, {"normal_z", "nz"})};
  if (all_there(normals)) {
    cloud.normals = vectors_of(records, normals);
    used.insert(used.end(), normals.begin(), normals.end());
  }
  const Field* packed = find(records, {"rgb", "rgba"});
  const std::array apart{find(records, {"red", "r", "diffuse_red"}), find(records, {"green", "g", "diffuse_green"}),
                         find(records, {"blue", "b", "diffuse_blue"})};
  if (packed != nullptr && size_of(packed->type) == 4) {
    cloud.colours = packed_colours(records, *packed);
    used.push_back(packed);
  } else if (all_there(apart)) {
    cloud.colours = apart_colours(records, apart);
    used.insert(used.end(), apart.begin(), apart.end());
  }
  for (const Field& field : records.fields) {
    if (field.count != 1 || field.name == "_" || std::find(used.begin(), used.end(), &field) != used.end()) continue;
    ScalarField& scalars = file.fields.emplace_back();
    scalars.name = field.name;
    scalars.values.resize(records.count);
    const Column column(records, field);
    for (std::size_t i = 0; i < records.count; ++i) scalars.values[i] = column.number(i);
  }
  return file;
}

std::optional<std::string_view> LineReader::next() {
  if (position_ >= bytes_.size()) return std::nullopt;
  const std::size_t end = std::min(bytes_.find('\n', position_), bytes_.size());
  std::string_view text = bytes_.substr(position_, end - position_);
  position_ = std::min(end + 1, bytes_.size());
  ++line_;
  if (text.ends_with('\r')) text.remove_suffix(1);
  return text;
}

std::string_view take_word(std::string_view& rest) {
  constexpr std::string_view kBlanks = " \t\r\n";
  const std::size_t first = std::min(rest.find_first_not_of(kBlanks), rest.size());
  const std::size_t last = std::min(rest.find_first_of(kBlanks, first), rest.size());
  const std::string_view word = rest.substr(first, last - first);
  rest.remove_prefix(last);
  return word;
}

std::vector<std::string_view> words_of(std::string_view line) {
  std::vector<std::string_view> words;
  for (std::string_view word = take_word(line); !word.empty(); word = take_word(line)) words.push_back(word);
  return words;
}

}  // namespace amiss::dataset
