// A page in HTML to send: title, paragraphs, tables, pictures and texts in one file that opens without a server and
// without a network. All texts are escaped; nothing is loaded; the same content gives the same bytes.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace amiss::report {

/// Text that is no markup.
[[nodiscard]] std::string escaped(std::string_view text);

/// How a row of a table stands out.
enum class RowStyle { kPlain, kGroup, kBad };

class Document {
 public:
  explicit Document(std::string_view title);

  void heading(std::string_view text);
  void paragraph(std::string_view text);
  void begin_table(const std::vector<std::string>& heading);
  void row(const std::vector<std::string>& fields, RowStyle style = RowStyle::kPlain);
  void end_table();
  /// What follows, until its end, is shown when the title is clicked.
  void begin_details(std::string_view title, bool open = false);
  void end_details();
  void preformatted(std::string_view text);
  /// The picture of a file, at most `width_px` wide, as JPEG. Of a file that holds none: the caption, and that it is
  /// not there.
  void picture(const std::filesystem::path& file, std::string_view caption, int width_px = 900);
  /// `svg`: the element, with ids that are nobody else's in this page.
  void drawing(std::string_view svg, std::string_view id, std::string_view caption);

  [[nodiscard]] std::string to_html() const;

 private:
  std::string html_;
};

}  // namespace amiss::report
