// The sub-commands of tessera. Each file adds its own to the parser and sets what runs when it is chosen.
#pragma once

#include <CLI/CLI.hpp>

#include "program/command.h"

namespace tessera::cli {

void add_library_command(CLI::App& app, Command& selected);
void add_collage_command(CLI::App& app, Command& selected);
void add_mosaic_command(CLI::App& app, Command& selected);
void add_texture_command(CLI::App& app, Command& selected);
void add_puzzle_command(CLI::App& app, Command& selected);
void add_nest_command(CLI::App& app, Command& selected);
void add_refine_command(CLI::App& app, Command& selected);
void add_draw_command(CLI::App& app, Command& selected);
void add_campaign_command(CLI::App& app, Command& selected);
void add_plan_command(CLI::App& app, Command& selected);
void add_report_command(CLI::App& app, Command& selected);
void add_serve_command(CLI::App& app, Command& selected);
void add_rank_command(CLI::App& app, Command& selected);
void add_recognize_command(CLI::App& app, Command& selected);
void add_card_command(CLI::App& app, Command& selected);
void add_match_command(CLI::App& app, Command& selected);
void add_keys_command(CLI::App& app, Command& selected);
void add_devices_command(CLI::App& app, Command& selected);

/// Only for the help: "tessera bench ..." is the command line of another program, tessera-bench.
void add_bench_command(CLI::App& app);
bool asks_for_bench(int argc, char** argv);
/// Replaces this program by tessera-bench from the same folder, with the arguments after "bench". Throws
/// EnvironmentError where it cannot be started.
[[noreturn]] void become_bench(char** argv);

}  // namespace tessera::cli
