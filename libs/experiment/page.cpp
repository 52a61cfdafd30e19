#include "experiment/page.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/files.hpp"
#include "experiment/merge.hpp"
#include "experiment/summary.hpp"
#include "report/document.hpp"

namespace amiss::experiment {

namespace {

void replace_all(std::string& text, std::string_view what, const std::string& with) {
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + with.size())) {
    text.replace(at, what.size(), with);
  }
}

/// `bad`: words of rows to be seen at once.
void add(report::Document& page, const Table& table, const std::vector<std::string>& bad = {}) {
  page.begin_table(table.heading);
  for (const auto& row : table.rows) {
    const bool is_bad = std::find_first_of(row.begin(), row.end(), bad.begin(), bad.end()) != row.end();
    page.row(row, is_bad ? report::RowStyle::kBad : report::RowStyle::kPlain);
  }
  page.end_table();
}

void add_details(report::Document& page, const std::string& title, std::string_view text, bool open = false) {
  page.begin_details(title, open);
  page.preformatted(text);
  page.end_details();
}

std::string overview(const Folder& folder, const std::vector<TrialResult>& results) {
  std::size_t failed = 0, all_found = 0;
  for (const TrialResult& r : results) {
    failed += r.failed ? 1U : 0U;
    all_found += r.complete() ? 1U : 0U;
  }
  const std::string program = folder.trials().empty() ? "" : folder.trials().front().program;
  return fmt::format(
      "{} trials planned: {} found all objects, {} found not all, {} failed, {} are missing. Program {}. A trial that "
      "found not all counts as longer than every other (inf); it is never left out. Intervals of medians hold 95 % "
      "(bootstrap); p is of Wilcoxon's signed-rank test, two-sided, on trials paired by their seed; the effect size is "
      "the matched-pairs rank-biserial correlation, 1 when the dynamic method needs less in every pair.",
      folder.trials().size(), all_found, results.size() - failed - all_found, failed,
      folder.trials().size() - results.size(), program);
}

}  // namespace

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
  report::Document page("Experiment: " + folder.spec().name);
  page.paragraph(overview(folder, results));
  page.heading("Batches");
  page.paragraph("Median (quartiles); times in simulated seconds, with the segmentation times of the thesis.");
  add(page, short_summary(folder.trials(), results));
  page.heading("Static against dynamic");
  add(page, short_statistics(folder.spec(), results));
  page.heading("Figures");
  for (const DrawnFigure& f : figures) {
    page.drawing(inlined(f.svg, f.name), f.name, fmt::format("{} (figures/{}.tsv)", f.title, f.name));
  }
  page.heading("Trials");
  page.begin_details("all trials");
  add(page, results_table(folder.trials(), results), {"failed", "missing"});
  page.end_details();
  page.heading("Spec, parameters and versions");
  add_details(page, "experiment.yaml", folder.spec_text(), true);
  for (const auto& [world, text] : folder.basis()) {
    add_details(page,
                "what the trials in " + world +
                    " depend on: version, robot, objects, planning domain, parameters, world, reference",
                text);
  }
  return page.to_html();
}

}  // namespace amiss::experiment
