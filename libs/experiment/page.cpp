#include "experiment/page.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/files.hpp"
#include "experiment/merge.hpp"
#include "experiment/summary.hpp"

namespace amiss::experiment {

namespace {

constexpr std::string_view kHead =
    R"(<!doctype html>
<html lang="en"><head><meta charset="utf-8">
<meta http-equiv="Content-Security-Policy" content="default-src 'none'; style-src 'unsafe-inline'; base-uri 'none'; form-action 'none'">
<meta name="viewport" content="width=device-width">
<title>{0}</title>
<style>
body {{ font: 15px/1.45 sans-serif; max-width: 75em; margin: 2em auto; padding: 0 1em; color: #222; background: #fff; }}
.wide {{ overflow-x: auto; }}
table {{ border-collapse: collapse; font-size: 13px; }}
th, td {{ padding: 3px 9px; border-bottom: 1px solid #ddd; text-align: left; white-space: nowrap; }}
th {{ border-bottom: 2px solid #888; position: sticky; top: 0; background: #fff; }}
pre {{ background: #f5f5f5; padding: 1em; overflow-x: auto; font-size: 12px; }}
figure {{ margin: 1.5em 0; }} figure svg {{ max-width: 100%; height: auto; }}
.failed td {{ background: #fde3d6; }}
</style></head><body>
<h1>Experiment: {0}</h1>
)";

void replace_all(std::string& text, std::string_view what, const std::string& with) {
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + with.size())) {
    text.replace(at, what.size(), with);
  }
}

std::string row_of(const std::vector<std::string>& fields, std::string_view element) {
  std::string row;
  for (const std::string& field : fields) row += fmt::format("<{0}>{1}</{0}>", element, escaped(field));
  return row;
}

/// `bad`: a word of rows to be seen at once.
std::string table_html(const Table& table, const std::vector<std::string>& bad = {}) {
  std::string html = "<div class=\"wide\"><table><thead><tr>" + row_of(table.heading, "th") + "</tr></thead><tbody>\n";
  for (const auto& row : table.rows) {
    bool is_bad = false;
    for (const std::string& field : row) is_bad = is_bad || std::find(bad.begin(), bad.end(), field) != bad.end();
    html += fmt::format("<tr{}>{}</tr>\n", is_bad ? " class=\"failed\"" : "", row_of(row, "td"));
  }
  return html + "</tbody></table></div>\n";
}

std::string details(const std::string& title, const std::string& inside, bool open = false) {
  return fmt::format("<details{}><summary>{}</summary>\n{}</details>\n", open ? " open" : "", escaped(title), inside);
}

std::string pre(std::string_view text) { return "<pre>" + escaped(text) + "</pre>\n"; }

std::string overview(const Folder& folder, const std::vector<TrialResult>& results) {
  std::size_t failed = 0, all_found = 0;
  for (const TrialResult& r : results) {
    failed += r.failed ? 1U : 0U;
    all_found += r.complete() ? 1U : 0U;
  }
  const std::string program = folder.trials().empty() ? "" : folder.trials().front().program;
  return fmt::format(
      "<p>{} trials planned: {} found all objects, {} found not all, {} failed, {} are missing. Program {}. A trial "
      "that "
      "found not all counts as longer than every other (inf); it is never left out. Intervals of medians hold 95 % "
      "(bootstrap); p is of Wilcoxon's signed-rank test, two-sided, on trials paired by their seed; the effect size is "
      "the "
      "matched-pairs rank-biserial correlation, 1 when the dynamic method needs less in every pair.</p>\n",
      folder.trials().size(), all_found, results.size() - failed - all_found, failed,
      folder.trials().size() - results.size(), escaped(program));
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

std::string inlined(std::string_view svg, const std::string& prefix) {
  const std::size_t begin = svg.find("<svg");
  std::string element(begin == std::string_view::npos ? "" : svg.substr(begin));
  for (const char* quote : {"'", "\""}) {
    replace_all(element, fmt::format(" id={}", quote), fmt::format(" id={}{}-", quote, prefix));
    replace_all(element, fmt::format("href={}#", quote), fmt::format("href={}#{}-", quote, prefix));
  }
  replace_all(element, "url(#", "url(#" + prefix + "-");
  return element;
}

std::string to_html(const Folder& folder, const std::vector<DrawnFigure>& figures) {
  const auto results = folder.results();
  std::string html = fmt::format(fmt::runtime(kHead), escaped(folder.spec().name)) + overview(folder, results);
  html +=
      "<h2>Batches</h2>\n<p>Median (quartiles); times in simulated seconds, with the segmentation times of the "
      "thesis.</p>\n" +
      table_html(short_summary(folder.trials(), results));
  html += "<h2>Static against dynamic</h2>\n" + table_html(short_statistics(folder.spec(), results));
  html += "<h2>Figures</h2>\n";
  for (const DrawnFigure& f : figures) {
    html += fmt::format("<figure id=\"{0}\">{1}<figcaption>{2} (figures/{0}.tsv)</figcaption></figure>\n",
                        escaped(f.name), inlined(f.svg, f.name), escaped(f.title));
  }
  html += "<h2>Trials</h2>\n" +
          details("all trials", table_html(results_table(folder.trials(), results), {"failed", "missing"}));
  html += "<h2>Spec, parameters and versions</h2>\n" + details("experiment.yaml", pre(folder.spec_text()), true);
  for (const auto& [world, text] : folder.basis()) {
    html += details("what the trials in " + world +
                        " depend on: version, robot, objects, planning domain, parameters, "
                        "world, reference",
                    pre(text));
  }
  return html + "</body></html>\n";
}

}  // namespace amiss::experiment
