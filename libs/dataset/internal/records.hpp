// Records of named scalars, as PLY's vertices and PCD's points are: packed little-endian, all of one length.
// What the two readers share: from text or bytes into records, from records to a cloud.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "dataset/cloud_files.hpp"

namespace amiss::dataset {

enum class Scalar { kI8, kU8, kI16, kU16, kI32, kU32, kI64, kU64, kF32, kF64 };
[[nodiscard]] std::size_t size_of(Scalar type);

struct Field {
  std::string name;
  Scalar type = Scalar::kF32;
  std::size_t count = 1;   // numbers in the field
  std::size_t offset = 0;  // in the record
};

struct Records {
  std::vector<Field> fields;
  std::size_t stride = 0, count = 0;
  std::string bytes;  // count * stride

  /// Appends the field to the layout.
  void add_field(std::string name, Scalar type, std::size_t number);
};

/// The number as text, appended in the bytes of the type; false where the text is no such number.
[[nodiscard]] bool append_number(std::string_view text, Scalar type, std::string& bytes);
/// The number that stands at `at`, little-endian.
[[nodiscard]] double number_at(const char* at, Scalar type);

/// InputError "NAME: ..." where x, y or z are missing.
[[nodiscard]] CloudFile cloud_of(const Records& records, const std::string& name);

/// The cloud's fields in the order x y z, colours (packed or apart), normals, the rest; names of normals differ.
enum class ColourLayout { kPacked, kApart };
[[nodiscard]] Records records_of(const CloudFile& cloud, ColourLayout colours, std::string_view normal_prefix);

/// Notes of a header as its lines, each behind the word that makes it a comment.
[[nodiscard]] std::string note_lines(const CloudFile& cloud, const std::string& comment);
/// Keeps what a comment says, without the word that makes it one and the blanks around.
void keep_note(std::string_view comment, std::vector<std::string>& notes);

/// The records as text, a line for each.
[[nodiscard]] std::string text_of(const Records& records);

/// Lines and words of a text with their number, for headers and ascii data.
class LineReader {
 public:
  explicit LineReader(std::string_view bytes) : bytes_(bytes) {}
  /// The next line without its end; nothing where the text is at its end.
  [[nodiscard]] std::optional<std::string_view> next();
  [[nodiscard]] std::size_t position() const { return position_; }  // behind the last line
  [[nodiscard]] int line() const { return line_; }                  // number of the last line, from 1

 private:
  std::string_view bytes_;
  std::size_t position_ = 0;
  int line_ = 0;
};
[[nodiscard]] std::vector<std::string_view> words_of(std::string_view line);
/// The next word of `rest`, which is shortened by it; empty at the end. Ends of lines are blanks.
[[nodiscard]] std::string_view take_word(std::string_view& rest);

}  // namespace amiss::dataset
