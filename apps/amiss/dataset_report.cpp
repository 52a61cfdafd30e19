#include "dataset_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "core/files.hpp"
#include "core/result.hpp"
#include "report/document.hpp"

namespace amiss::app {

namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr int kPicture_px = 320;

/// What recording.json says, in the order of the table.
std::vector<std::string> row_of(const fs::path& recording) {
  const fs::path file = recording / "recording.json";
  try {
    const json told = json::parse(load_bytes(file));
    const auto number = [&](const char* key) { return told.at(key).get<double>(); };
    const json& localization = told.at("localization");
    return {told.at("room").get<std::string>(),
            told.at("scene").get<std::string>(),
            fmt::format("{}", told.at("frames").get<int>()),
            fmt::format("{} of {}", told.at("reached").get<int>(), told.at("waypoints").get<int>()),
            fmt::format("{:.1f}", number("distance_m")),
            fmt::format("{:.1f}", number("simulated_s")),
            fmt::format("{}", told.at("collisions").get<int>()),
            fmt::format("{:.1f}", 1e3 * localization.at("rmse_m").get<double>())};
  } catch (const json::exception& e) {
    throw InputError(file.string() + ": is no report of a recording: " + e.what());
  }
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

std::string dataset_page(const std::string& summary, const std::string& parameters,
                         const std::vector<fs::path>& recordings) {
  report::Document page("Data set");
  page.paragraph(fmt::format("{}, made by amiss {}.", summary, AMISS_VERSION));
  page.begin_table({"room", "scene", "frames", "waypoints reached", "driven [m]", "simulated [s]", "collisions",
                    "error of the pose, RMS [mm]"});
  std::string room;
  for (const fs::path& recording : recordings) {
    const auto row = row_of(recording);
    page.row(row, row.front() == room ? report::RowStyle::kPlain : report::RowStyle::kGroup);
    room = row.front();
  }
  page.end_table();
  page.heading("What the camera saw");
  for (const fs::path& recording : recordings) {
    const std::string name = (recording.parent_path().filename() / recording.filename()).string();
    page.picture(middle_of(recording / "rgb"), name, kPicture_px);
  }
  page.heading("Parameters");
  page.begin_details("dataset.yaml");
  page.preformatted(parameters);
  page.end_details();
  return page.to_html();
}

}  // namespace amiss::app
