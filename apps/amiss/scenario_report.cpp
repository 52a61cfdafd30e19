#include "scenario_report.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "report/document.hpp"

namespace amiss::app {

namespace {

std::filesystem::path with_ending(std::filesystem::path stem, const char* ending) { return stem += ending; }

}  // namespace

std::string scenarios_page(const std::vector<JobResult>& results, const std::vector<std::filesystem::path>& kept) {
  const auto good = std::count_if(results.begin(), results.end(),
                                  [](const JobResult& r) { return r.finished && r.exit_status == 0; });
  report::Document page("Scenarios");
  page.paragraph(fmt::format("{} of {} as expected. amiss {}.", good, results.size(), AMISS_VERSION));
  page.begin_table({"scenario", "", "simulated [s]", "what failed"});
  for (const JobResult& r : results) {
    if (!r.finished) {
      page.row({r.job.name, "not finished", "-", ""}, report::RowStyle::kBad);
      continue;
    }
    page.row({r.job.name, std::string(verdict_of(r)), fmt::format("{:.1f}", r.simulated_s),
              fmt::format("{}", fmt::join(r.sentences, "; "))},
             r.exit_status == 0 ? report::RowStyle::kPlain : report::RowStyle::kBad);
  }
  page.end_table();
  page.heading("Runs");
  for (std::size_t i = 0; i < results.size(); ++i) {
    if (!results[i].finished) continue;
    page.begin_details(results[i].job.name, results[i].exit_status != 0);
    page.picture(with_ending(kept[i], ".png"), results[i].job.name);
    page.preformatted(results[i].log);
    page.end_details();
  }
  return page.to_html();
}

}  // namespace amiss::app
