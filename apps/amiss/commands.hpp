// One function for each subcommand: declares its options and sets the exit status when it ran.
#pragma once

#include <array>

namespace CLI {
class App;
}

namespace amiss::app {

inline constexpr int kGoalMet = 0, kGoalNotMet = 1, kWrongArguments = 2, kUnreadableInput = 3, kProgramFailed = 4,
                     kInterrupted = 130;

struct ExitStatus {
  int value;
  const char* meaning;
};
inline constexpr std::array kExitStatuses{
    ExitStatus{kGoalMet, "done and the goal met"},
    ExitStatus{kGoalNotMet, "ran to its end, goal not met"},
    ExitStatus{kWrongArguments, "wrong arguments or parameters"},
    ExitStatus{kUnreadableInput, "an input that cannot be read"},
    ExitStatus{kProgramFailed, "the program failed (scenario only)"},
    ExitStatus{kInterrupted, "interrupted"},
};

void add_tidy_command(CLI::App& app, int& exit_status);
void add_experiment_command(CLI::App& app, int& exit_status);
void add_dataset_command(CLI::App& app, int& exit_status);
void add_map_command(CLI::App& app, int& exit_status);
void add_diff_command(CLI::App& app, int& exit_status);
void add_detect_command(CLI::App& app, int& exit_status);
void add_evaluate_command(CLI::App& app, int& exit_status);
void add_plan_command(CLI::App& app, int& exit_status);
void add_reconstruct_command(CLI::App& app, int& exit_status);
void add_scenario_command(CLI::App& app, int& exit_status);
void add_replay_command(CLI::App& app, int& exit_status);
void add_semantics_command(CLI::App& app, int& exit_status);
void add_view_command(CLI::App& app, int& exit_status);
void add_video_command(CLI::App& app, int& exit_status);
void add_scene_command(CLI::App& app, int& exit_status);
void add_worlds_command(CLI::App& app, int& exit_status);
void add_objects_command(CLI::App& app, int& exit_status);
void add_init_command(CLI::App& app, int& exit_status);
void add_doctor_command(CLI::App& app, int& exit_status);
void add_completion_command(CLI::App& app, int& exit_status);
void add_man_command(CLI::App& app, int& exit_status);

}  // namespace amiss::app
