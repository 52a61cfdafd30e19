// One tidy-up run from worlds to run folder: everything that `amiss tidy` does once its arguments are read.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "report/tidy_report.hpp"
#include "settings.hpp"
#include "view_options.hpp"

namespace amiss::app {

struct TidyOptions {
  std::string world = "flat_90";
  std::string method = "dynamic";
  std::string reference_world;  // where it is not the same
  std::optional<int> objects;   // to scatter; 5 where nothing else is said
  std::string scatter_file;
  std::uint64_t seed = 1;
  std::optional<std::uint64_t> scatter_seed;  // of what is scattered where; the seed where nothing else is said
  bool until_found = true;
  double time_limit_s = 3600.0;
  std::string out;
  std::string robot;  // URDF file
  std::vector<std::string> model_paths;
  std::vector<double> start;  // x and y in m, heading in degrees, of the world; empty: as the world says
  int threads = 2;
  bool quiet = false;
  ViewOptions view;
  std::string record;  // mcap, rawlog, both: recordings in the run folder
};

class RunPage;

struct TidyOutcome {
  report::TidyReport report;
  std::string json;
  std::string folder;
  int exit_status = 0;
  std::shared_ptr<RunPage> page;  // may be served on
};

[[nodiscard]] TidyOutcome run_tidy(const TidyOptions& options, Settings settings);

}  // namespace amiss::app
