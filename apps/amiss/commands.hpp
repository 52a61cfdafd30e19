// One function for each subcommand: declares its options and sets the exit status when it ran.
// 0 done and the goal met; 1 ran to its end, goal not met; 2 wrong arguments or parameters; 3 an input that cannot be
// read; 4 the program failed (scenario only); 130 interrupted.
#pragma once

namespace CLI {
class App;
}

namespace amiss::app {

inline constexpr int kGoalMet = 0, kGoalNotMet = 1, kWrongArguments = 2, kUnreadableInput = 3, kProgramFailed = 4,
                     kInterrupted = 130;

void add_tidy_command(CLI::App& app, int& exit_status);
void add_experiment_command(CLI::App& app, int& exit_status);
void add_dataset_command(CLI::App& app, int& exit_status);
void add_map_command(CLI::App& app, int& exit_status);
void add_diff_command(CLI::App& app, int& exit_status);
void add_plan_command(CLI::App& app, int& exit_status);
void add_scenario_command(CLI::App& app, int& exit_status);
void add_view_command(CLI::App& app, int& exit_status);
void add_worlds_command(CLI::App& app, int& exit_status);
void add_objects_command(CLI::App& app, int& exit_status);

}  // namespace amiss::app
