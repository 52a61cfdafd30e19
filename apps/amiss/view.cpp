// amiss view RUN: a run folder in a browser.
#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>
#include <thread>

#include "commands.hpp"
#include "interrupt.hpp"
#include "page/run_files.hpp"
#include "view_options.hpp"

namespace amiss::app {

namespace {

void show(const std::string& folder, const ViewOptions& options) {
  catch_interrupts();
  page::History history;
  for (std::string& line : page::load_timeline(folder)) history.append(std::move(line));
  const page::Server server(options.server, page::served_files(folder), history, nullptr);
  announce(server, options);
  std::cerr << "amiss: Ctrl+C ends it" << std::endl;
  while (!interrupted()) std::this_thread::sleep_for(std::chrono::milliseconds(100));
}

}  // namespace

void add_view_command(CLI::App& app, int& exit_status) {
  struct Arguments {
    std::string folder;
    ViewOptions options;
  };
  const auto a = std::make_shared<Arguments>();
  CLI::App* view = app.add_subcommand("view", "show a run folder in a browser, until interrupted");
  view->add_option("RUN", a->folder, "run folder of a tidy-up run")->type_name("DIR")->required();
  add_view_options(*view, a->options, false);
  view->callback([a, &exit_status] {
    show(a->folder, a->options);
    exit_status = kGoalMet;
  });
}

}  // namespace amiss::app
