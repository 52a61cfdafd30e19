#include "dataset_report.hpp"

#include <fmt/format.h>
#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "core/files.hpp"
#include "core/result.hpp"
#include "experiment/table.hpp"
#include "library_versions.hpp"
#include "report_figure.hpp"

namespace amiss::app {

namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr int kPicture_px = 320;

/// What a recording says of itself, and how many objects lay there.
struct Told {
  std::string room, scene;
  std::size_t objects = 0;
  double error_mm = 0.0;
  std::vector<std::string> row;  // of the table
};

Told told_by(const fs::path& recording) {
  const fs::path file = recording / "recording.json";
  try {
    const json told = json::parse(load_bytes(file));
    const auto number = [&](const char* key) { return told.at(key).get<double>(); };
    Told result{told.at("room"),
                told.at("scene"),
                YAML::Load(load_bytes(recording / "truth" / "objects.yaml")).size(),
                1e3 * told.at("localization").at("rmse_m").get<double>(),
                {}};
    result.row = {result.room,
                  result.scene,
                  fmt::format("{}", result.objects),
                  fmt::format("{}", told.at("frames").get<int>()),
                  fmt::format("{} of {}", told.at("reached").get<int>(), told.at("waypoints").get<int>()),
                  fmt::format("{:.1f}", number("distance_m")),
                  fmt::format("{:.1f}", number("simulated_s")),
                  fmt::format("{}", told.at("collisions").get<int>()),
                  fmt::format("{:.1f}", result.error_mm)};
    return result;
  } catch (const json::exception& e) {
    throw InputError(file.string() + ": is no report of a recording: " + e.what());
  }
}

/// Objects and localization, a bar for each visit, one above the other.
experiment::Figure visits_figure(const std::vector<Told>& visits) {
  const std::string name = "visits";
  experiment::Table table{{"visit", "objects", "error_mm"}, {}};
  for (const Told& visit : visits) {
    table.rows.push_back(
        {visit.room + " " + visit.scene, std::to_string(visit.objects), fmt::format("{:.2f}", visit.error_mm)});
  }
  const auto bars = [&](const char* column, const char* labels, const char* colour) {
    return fmt::format("plot '{}.tsv' using (column(0)):'{}'{} with boxes lc rgb '{}' notitle\n", name, column, labels,
                       colour);
  };
  const std::string script = figure_head(name) +
                             fmt::format(
                                 "set boxwidth 0.7\nset xrange [-0.7:{}]\nset yrange [0:*]\n"
                                 "set lmargin 9\nset rmargin 2\nset multiplot\n",
                                 static_cast<double>(visits.size()) - 0.3) +
                             "set size 1,0.42\nset origin 0,0.58\nset bmargin 1\nset format x ''\nset xtics scale 0\n"
                             "set ylabel 'objects'\n" +
                             bars("objects", "", "#0072b2") +
                             "set size 1,0.58\nset origin 0,0\nset bmargin 9\nset format x\n"
                             "set xtics rotate by 60 right font ',9'\nset ylabel 'error of the pose, RMS (mm)'\n" +
                             bars("error_mm", ":xtic(strcol('visit'))", "#d55e00") + "unset multiplot\n";
  return {name,
          "Objects and error of the robot's localization, visit by visit",
          {{name + ".tsv", experiment::to_tsv(table)}, {name + ".gp", script}}};
}

/// The colour image in the middle of a recording; the folder where there is none.
fs::path middle_of(const fs::path& images) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(images)) files.push_back(entry.path());
  if (files.empty()) return images;
  const auto middle = files.begin() + static_cast<std::ptrdiff_t>(files.size() / 2);
  std::nth_element(files.begin(), middle, files.end());
  return *middle;
}

}  // namespace

void save_dataset_report(const fs::path& folder, const std::string& summary, const std::string& parameters,
                         const std::vector<fs::path>& recordings) {
  std::vector<Told> visits;
  for (const fs::path& recording : recordings) visits.push_back(told_by(recording));
  report::Document page("Data set");
  page.paragraph(fmt::format("{}, made by amiss {} ({}).", summary, AMISS_VERSION, library_versions()));
  page.begin_table({"room", "scene", "objects", "frames", "waypoints reached", "driven [m]", "simulated [s]",
                    "collisions", "error of the pose, RMS [mm]"});
  std::string room;
  for (const Told& visit : visits) {
    page.row(visit.row, visit.room == room ? report::RowStyle::kPlain : report::RowStyle::kGroup);
    room = visit.room;
  }
  page.end_table();
  add_figure(page, visits_figure(visits), folder);
  page.heading("What the camera saw");
  for (const fs::path& recording : recordings) {
    const std::string name = (recording.parent_path().filename() / recording.filename()).string();
    page.picture(middle_of(recording / "rgb"), name, kPicture_px);
  }
  page.heading("Parameters");
  page.begin_details("dataset.yaml");
  page.preformatted(parameters);
  page.end_details();
  save_atomically(folder / "report.html", page.to_html());
}

}  // namespace amiss::app
