#include "evaluate_tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "core/files.hpp"
#include "evaluate_figure.hpp"
#include "experiment/table_markup.hpp"
#include "library_versions.hpp"
#include "report_figure.hpp"

namespace amiss::app {

namespace {

using nlohmann::ordered_json;

std::vector<score::NovelRow> rows_of(const JudgedRooms& judged) {
  std::vector<score::NovelTrial> trials;
  for (const TrialResult& r : judged.results) trials.push_back(r.trial);
  return score::table52(trials);
}

std::vector<std::string> cells_of(const score::NovelRow& row, const std::string* reconstruction) {
  std::vector<std::string> cells = {row.room};
  if (reconstruction != nullptr) cells.push_back(*reconstruction);
  cells.push_back(row.method);
  for (const score::MeanAndDeviation& value : {row.precision, row.recall, row.f1}) {
    cells.push_back(fmt::format("{:.4f}", value.mean));
    cells.push_back(fmt::format("{:.4f}", value.deviation));
  }
  cells.push_back(experiment::number_text(row.missed));
  cells.push_back(experiment::number_text(row.wrong));
  return cells;
}

/// Room by room in the order in which they come, the average last; of a room, one reconstruction after the other.
experiment::Table table_of(const std::vector<JudgedRooms>& judged) {
  const bool several = !judged.front().reconstruction.empty();
  experiment::Table table{
      {"room", "method", "precision", "precision_sd", "recall", "recall_sd", "f1", "f1_sd", "missed", "wrong"}, {}};
  if (several) table.heading.insert(table.heading.begin() + 1, "reconstruction");
  std::vector<std::vector<score::NovelRow>> rows;
  std::vector<std::string> rooms;
  for (const JudgedRooms& one : judged) {
    for (const score::NovelRow& row : rows.emplace_back(rows_of(one))) {
      if (row.room != kAverageRoom && std::find(rooms.begin(), rooms.end(), row.room) == rooms.end()) {
        rooms.push_back(row.room);
      }
    }
  }
  rooms.emplace_back(kAverageRoom);
  for (const std::string& room : rooms) {
    for (std::size_t i = 0; i < judged.size(); ++i) {
      for (const score::NovelRow& row : rows[i]) {
        if (row.room == room) table.rows.push_back(cells_of(row, several ? &judged[i].reconstruction : nullptr));
      }
    }
  }
  return table;
}

std::string rests_on(const JudgedRooms& judged) {
  std::vector<std::string> labels;
  std::size_t objects = 0, with_space = 0;
  const std::string first = judged.results.front().trial.method;
  for (const TrialResult& r : judged.results) {
    const std::string kind = r.labels.substr(0, r.labels.find(" of "));
    if (std::find(labels.begin(), labels.end(), kind) == labels.end()) labels.push_back(kind);
    if (r.trial.method != first) continue;
    objects += r.objects;
    with_space += r.space != "none" ? 1U : 0U;
  }
  const std::string name = judged.reconstruction.empty() ? "" : judged.reconstruction + ": ";
  return fmt::format("{}{} visits with {} annotated objects. Labels: {}. Seen space is known for {} visits.", name,
                     judged.list.visits.size(), objects, fmt::join(labels, "; "), with_space);
}

std::vector<std::string> sentences_of(const std::vector<JudgedRooms>& judged) {
  std::vector<std::string> sentences;
  for (const JudgedRooms& one : judged) sentences.push_back(rests_on(one));
  sentences.emplace_back(
      "Precision, recall and F1 are counted over points; mean and standard deviation over the visits of a room, missed "
      "objects and wrong clusters summed. average: means of the rooms, deviations over all visits.");
  for (const JudgedRooms& one : judged) {
    const std::string name = one.reconstruction.empty() ? "" : one.reconstruction + ", ";
    for (const std::string& why : one.list.left_out) sentences.push_back("Left out: " + name + why + ".");
  }
  return sentences;
}

std::string report_of(const std::vector<JudgedRooms>& judged, const std::string& stem) {
  double longest_s = 0.0;
  std::size_t before = 0, trials = 0, visits = 0;
  ordered_json left_out = ordered_json::array(), datasets = ordered_json::array();
  for (const JudgedRooms& one : judged) {
    datasets.push_back(one.dataset);
    visits += one.list.visits.size();
    trials += one.results.size();
    for (const std::string& why : one.list.left_out) left_out.push_back(why);
    for (const TrialResult& r : one.results) {
      longest_s = std::max(longest_s, r.wall_s);
      before += r.done_before ? 1U : 0U;
    }
  }
  const ordered_json report = {{"schema", "amiss." + stem + ".1"},
                               {"version", AMISS_VERSION},
                               {"dataset", judged.size() == 1 ? datasets.front() : datasets},
                               {"visits", visits},
                               {"trials", trials},
                               {"left_out", left_out},
                               {"wall", {{"longest_detection_s", longest_s}, {"done_before", before}}}};
  return report.dump(2, ' ', false, ordered_json::error_handler_t::replace) + "\n";
}

/// What the last method (the thesis' own) found on each visit.
void add_visits(report::Document& page, const std::vector<JudgedRooms>& judged) {
  page.heading("Visits");
  for (const JudgedRooms& one : judged) {
    const std::string method = one.results.back().trial.method;
    const std::string name = one.reconstruction.empty() ? "" : one.reconstruction + ", ";
    page.begin_details(fmt::format("{}{}: what was found, from above", name, method));
    for (const TrialResult& r : one.results) {
      if (r.trial.method != method) continue;
      const std::string missed = r.missed.empty() ? "none" : fmt::format("{}", fmt::join(r.missed, ", "));
      page.picture(r.picture, fmt::format("{}, {}: {} objects, {} clusters; missed: {}", r.trial.room, r.scene,
                                          r.objects, r.clusters, missed));
    }
    page.end_details();
  }
}

/// Table, figure, visits; the figure's files into `out`.
std::string page_of(const SavedTable& saved, const std::vector<JudgedRooms>& judged, const std::string& parameters,
                    const std::string& stem, const std::filesystem::path& out) {
  report::Document page(saved.title);
  for (const std::string& sentence : saved.sentences) page.paragraph(sentence);
  experiment::add_grouped(page, saved.table);
  add_figure(page, averages_figure(saved.table, stem + "_averages"), out);
  add_visits(page, judged);
  page.heading("Parameters and versions");
  page.paragraph("amiss " AMISS_VERSION "; " + library_versions());
  page.begin_details("parameters");
  page.preformatted(parameters);
  page.end_details();
  return page.to_html();
}

}  // namespace

SavedTable save_tables(const std::vector<JudgedRooms>& judged, const DetectSettings& settings, const std::string& stem,
                       const std::filesystem::path& out) {
  const std::string title = judged.front().reconstruction.empty()
                                ? "Novel objects: Table 5.2"
                                : "Novel objects by methods of reconstruction (5.3.6)";
  const SavedTable saved{title, sentences_of(judged), table_of(judged)};
  save_atomically(out / "params.yaml", settings.as_yaml());
  save_atomically(out / "report.html", page_of(saved, judged, settings.as_yaml(), stem, out));
  save_atomically(out / (stem + ".tsv"), experiment::to_tsv(saved.table));
  save_atomically(out / (stem + ".md"),
                  fmt::format("{}\n\n{}", fmt::join(saved.sentences, "\n\n"), experiment::to_markdown(saved.table)));
  save_atomically(out / (stem + ".html"), experiment::to_page(title, saved.sentences, saved.table));
  save_atomically(out / "report.json", report_of(judged, stem));
  return saved;
}

}  // namespace amiss::app
