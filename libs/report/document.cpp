#include "report/document.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "core/base64.hpp"

namespace amiss::report {

namespace {

constexpr int kJpegQuality = 82;

constexpr std::string_view kHead =
    R"(<!doctype html>
<html lang="en"><head><meta charset="utf-8">
<meta http-equiv="Content-Security-Policy" content="default-src 'none'; style-src 'unsafe-inline'; img-src data:; base-uri 'none'; form-action 'none'">
<meta name="viewport" content="width=device-width">
<title>{0}</title>
<style>
:root {{ color-scheme: light dark; --line: #8886; --bad: #e8501a30; --box: #8881; }}
body {{ font: 15px/1.45 system-ui, sans-serif; max-width: 75em; margin: 2em auto; padding: 0 1em; }}
.wide {{ overflow-x: auto; }}
table {{ border-collapse: collapse; font-size: 13px; }}
th, td {{ padding: 3px 9px; border-bottom: 1px solid var(--line); text-align: left; white-space: nowrap; }}
th {{ border-bottom: 2px solid #888; }}
tr.group td {{ border-top: 1px solid #888; }}
tr.bad td {{ background: var(--bad); white-space: normal; }}
pre {{ background: var(--box); padding: 1em; overflow-x: auto; font-size: 12px; }}
figure {{ display: inline-block; margin: 1em 1em 1em 0; max-width: 100%; }}
figure svg, figure img {{ max-width: 100%; height: auto; background: #fff; }}
summary {{ cursor: pointer; }}
</style></head><body>
<h1>{0}</h1>
)";

std::string cells(const std::vector<std::string>& fields, std::string_view element) {
  std::string row;
  for (const std::string& field : fields) row += fmt::format("<{0}>{1}</{0}>", element, escaped(field));
  return row;
}

}  // namespace

std::string escaped(std::string_view text) {
  std::string safe;
  for (const char c : text) {
    switch (c) {
      case '&':
        safe += "&amp;";
        break;
      case '<':
        safe += "&lt;";
        break;
      case '>':
        safe += "&gt;";
        break;
      case '"':
        safe += "&quot;";
        break;
      default:
        safe += c;
    }
  }
  return safe;
}

Document::Document(std::string_view title) : html_(fmt::format(fmt::runtime(kHead), escaped(title))) {}

void Document::heading(std::string_view text) { html_ += fmt::format("<h2>{}</h2>\n", escaped(text)); }

void Document::paragraph(std::string_view text) { html_ += fmt::format("<p>{}</p>\n", escaped(text)); }

void Document::begin_table(const std::vector<std::string>& heading) {
  html_ += "<div class=\"wide\"><table><thead><tr>" + cells(heading, "th") + "</tr></thead><tbody>\n";
}

void Document::row(const std::vector<std::string>& fields, RowStyle style) {
  const char* attribute = style == RowStyle::kBad     ? " class=\"bad\""
                          : style == RowStyle::kGroup ? " class=\"group\""
                                                      : "";
  html_ += fmt::format("<tr{}>{}</tr>\n", attribute, cells(fields, "td"));
}

void Document::end_table() { html_ += "</tbody></table></div>\n"; }

void Document::begin_details(std::string_view title, bool open) {
  html_ += fmt::format("<details{}><summary>{}</summary>\n", open ? " open" : "", escaped(title));
}

void Document::end_details() { html_ += "</details>\n"; }

void Document::preformatted(std::string_view text) { html_ += "<pre>" + escaped(text) + "</pre>\n"; }

void Document::picture(const std::filesystem::path& file, std::string_view caption, int width_px) {
  cv::Mat image = cv::imread(file.string(), cv::IMREAD_COLOR);
  if (image.empty()) return paragraph(fmt::format("{}: {} is not there", caption, file.filename().string()));
  const double scale = std::min(1.0, static_cast<double>(width_px) / image.cols);
  cv::resize(image, image, {}, scale, scale, cv::INTER_AREA);
  std::vector<unsigned char> jpeg;
  cv::imencode(".jpg", image, jpeg, {cv::IMWRITE_JPEG_QUALITY, kJpegQuality});
  html_ +=
      fmt::format("<figure><img alt=\"{0}\" src=\"data:image/jpeg;base64,{1}\"><figcaption>{0}</figcaption></figure>\n",
                  escaped(caption), base64(std::string(jpeg.begin(), jpeg.end())));
}

void Document::drawing(std::string_view svg, std::string_view id, std::string_view caption) {
  html_ +=
      fmt::format("<figure id=\"{}\">{}<figcaption>{}</figcaption></figure>\n", escaped(id), svg, escaped(caption));
}

std::string Document::to_html() const { return html_ + "</body></html>\n"; }

}  // namespace amiss::report
