// tessera: parses the command line and runs the sub-command.
#include <CLI/CLI.hpp>

#include <string>

#include "cli/commands.h"
#include "core/base/version.h"
#include "program/parsed_command.h"
#include "program/run_main.h"

namespace tessera::cli {
namespace {

void add_commands(CLI::App& app, Command& selected) {
  app.set_version_flag("--version", std::string("tessera ") + program_version() + ", commit " + program_commit());
  app.require_subcommand(1);
  app.footer(
      "First steps:\n"
      "  tessera devices                                  what this machine computes on\n"
      "  tessera collage my_drawings/                     a first collage of a folder's drawings\n"
      "  tessera library build my_svgs/ -o my.h5          a library from artwork\n"
      "  tessera collage my_job.toml                      a collage from it (docs/job-format.md)\n"
      "  tessera keys pieces                              the keys of a job's table [pieces]\n"
      "  mpirun -n 3 tessera collage my_job.toml          the same on a master and two workers\n"
      "  tessera mosaic my_photo.jpg my.h5                a picture made of it: the job and the collage\n"
      "  tessera texture my_wall.jpg                      a larger wall without seams\n"
      "  tessera puzzle solve pieces.h5 --size 600,400    a jigsaw's pieces laid together\n"
      "  tessera nest parts.svg --strip 600               shapes of fixed sizes on the shortest strip\n"
      "  tessera refine out/my_job --relax                less room between its pieces: out/my_job-relaxed\n"
      "  tessera serve out/my_job                         look at it in a browser, and refine it there\n"
      "  tessera draw out/my_job --width 12000            its pictures again, larger\n"
      "  tessera campaign my_job.toml --seeds 1-8         eight of them, ranked by quality\n"
      "  tessera card theirs.geojson --size 1000,800      anybody's collage, by the same measures\n"
      "  tessera recognize torn.png --library my.h5       which of its drawings a picture is a part of\n"
      "  tessera match duck.svg goose.svg                 which parts of two drawings are alike\n"
      "Exit codes: 0 done, 1 the machine failed (disk, memory, device), 2 bad input, 3 done, but something that was\n"
      "counted is missing (warnings name it), 75 interrupted; the last line on stderr says how to go on.");
  add_library_command(app, selected);
  add_collage_command(app, selected);
  add_mosaic_command(app, selected);
  add_texture_command(app, selected);
  add_refine_command(app, selected);
  add_puzzle_command(app, selected);
  add_nest_command(app, selected);
  add_draw_command(app, selected);
  add_campaign_command(app, selected);
  add_plan_command(app, selected);
  add_report_command(app, selected);
  add_serve_command(app, selected);
  add_rank_command(app, selected);
  add_card_command(app, selected);
  add_recognize_command(app, selected);
  add_match_command(app, selected);
  add_keys_command(app, selected);
  add_devices_command(app, selected);
  add_bench_command(app);
}

Command command_of(int argc, char** argv) {
  if (asks_for_bench(argc, argv)) become_bench(argv);
  CLI::App app("Collages of shapes, on one machine or a cluster.", "tessera");
  Command selected;
  add_commands(app, selected);
  return parsed_command(app, selected, argc, argv);
}

}  // namespace
}  // namespace tessera::cli

int main(int argc, char** argv) {
  return tessera::run_main(argc, argv, [&] { return tessera::cli::command_of(argc, argv); });
}
