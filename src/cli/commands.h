// The sub-commands of tessera. Each file adds its own to the parser and says what to run when it is the one given.
#pragma once

#include <CLI/CLI.hpp>

#include <functional>
#include <optional>
#include <string>

#include "comm/communicator.h"

namespace tessera::cli {

/// What the chosen sub-command runs: one of the two. Both return the exit code and throw InputError and
/// EnvironmentError.
struct Command {
  std::function<int()> run = {};  // on rank 0 alone
  std::function<int(comm::Communicator&)> run_on_all_ranks = {};
  /// The value of --time-limit, where it is given: MPI's start must keep to it before the command runs.
  std::optional<std::string> time_limit = {};
};

void add_library_command(CLI::App& app, Command& selected);
void add_collage_command(CLI::App& app, Command& selected);
void add_mosaic_command(CLI::App& app, Command& selected);
void add_puzzle_command(CLI::App& app, Command& selected);
void add_nest_command(CLI::App& app, Command& selected);
void add_refine_command(CLI::App& app, Command& selected);
void add_draw_command(CLI::App& app, Command& selected);
void add_campaign_command(CLI::App& app, Command& selected);
void add_plan_command(CLI::App& app, Command& selected);
void add_rank_command(CLI::App& app, Command& selected);
void add_card_command(CLI::App& app, Command& selected);
void add_devices_command(CLI::App& app, Command& selected);
void add_bench_command(CLI::App& app, Command& selected);

}  // namespace tessera::cli
