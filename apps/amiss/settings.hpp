// All parameters of a run: of the thinking part, the simulator, scattering and the referee.
#pragma once

#include "mission/params.hpp"
#include "score/referee.hpp"
#include "sim/scatter.hpp"
#include "sim/simulator.hpp"
#include "world/loader.hpp"

namespace amiss::app {

struct Settings {
  mission::Params mission;
  sim::SimulatorParams simulator;
  sim::ScatterParams scatter;
  score::RefereeParams referee;
  world::LoadOptions world;

  [[nodiscard]] ParamTable table();
  /// The parameters that the mapping run depends on, as text: part of the key of a cached reference.
  [[nodiscard]] std::string reference_key();
};

/// Defaults, then the file (if any), then the overrides.
[[nodiscard]] Settings load_settings(const std::string& params_file, const std::vector<std::string>& overrides);

}  // namespace amiss::app
