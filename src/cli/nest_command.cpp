#include <memory>

#include "cli/commands.h"
#include "program/list_option.h"
#include "run/nesting/nest_run.h"

namespace tessera::cli {
namespace {

constexpr const char* kNestExamples =
    "Examples:\n"
    "  tessera nest parts.svg --strip 600                      the shortest strip, 600 mm high: out/parts\n"
    "  tessera nest parts.dxf --sheet 1000,500 --spacing 2     as few sheets as it takes, 2 mm between pieces\n"
    "  tessera nest swim.json --effort best                    an instance with its own strip, demands and angles\n"
    "  tessera nest parts/ --strip 600 --demand 'wheel*=4' --demand lid=2 --angles 0,180\n"
    "  tessera nest animals.h5 --sheet 420,297                 and a job that tessera collage draws\n"
    "INPUT: an instance of sparrow or jagua-rs (.json), an SVG, a DXF, a folder of these two, or a library. Pieces "
    "keep\n"
    "their sizes; each closed outline is one, with the holes in it. Where an SVG or DXF names no unit, a warning says\n"
    "what 1 unit was taken as: 1/96 inch, 1 mm. --demand finds a piece by its id, or by its file's name if the file "
    "has only this piece.\n"
    "DIR gets layout.svg and .dxf in mm for the cutter, layout.png as a picture, layout.json, card.txt. Pieces without "
    "a\n"
    "place are named, and the exit code is 3. After --time-limit, Ctrl-C, SIGTERM or a lost rank the best layout so "
    "far is\n"
    "written; that layout depends on the time.";

}  // namespace

// The options, one in a row of the table.
void add_nest_command(CLI::App& app, Command& selected) {
  const auto arguments = std::make_shared<NestArguments>();
  CLI::App* command = app.add_subcommand("nest", "Lay shapes of fixed sizes densely on a strip or on sheets");
  command->footer(kNestExamples);
  command->add_option("INPUT", arguments->input, "What is laid")->required()->type_name("PATH");
  command
      ->add_option("--strip", arguments->strip_mm,
                   "A strip of this height, as short as possible; default: the instance's")
      ->type_name("MM");
  add_list_option(*command, "--sheet", arguments->sheet_mm,
                  "Sheets of this size, as few as possible; default: the instance's bin",
                  {.type_name = "W,H", .count = 2});
  add_list_option(*command, "--angles", arguments->angles_deg,
                  "Angles by which pieces may be turned, degrees; default: the instance's, or 0,90,180,270",
                  {.type_name = "DEG,..."});
  command
      ->add_option("--demand", arguments->demands,
                   "Number of pieces of each shape with this name, which may have * and ?; default: 1, or the "
                   "instance's")
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
      ->type_name("NAME=COUNT");
  command
      ->add_option("--leave-out", arguments->left_out,
                   "Id of an SVG element that is not cut, such as the rectangle of a bed; elements inside it are cut")
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
      ->type_name("NAME");
  command
      ->add_option("--dpi", arguments->px_per_inch,
                   "Number of px in an inch of an SVG: 90 for Inkscape up to 0.91, 72 for Illustrator; default: 96")
      ->check(CLI::Range(1.0, 10'000.0))
      ->type_name("PX");
  command->add_option("--spacing", arguments->spacing_mm, "Least distance between pieces, mm")->capture_default_str();
  command
      ->add_option(
          "--effort", arguments->effort,
          "Time of the search; 50 simple pieces on two cores take seconds, half a minute, or minutes; draft and good "
          "run two searches, best four: more cores do not help")
      ->check(CLI::IsMember({"draft", "good", "best"}))
      ->capture_default_str();
  command->add_option("--seed", arguments->seed, "Another seed, another layout")->capture_default_str();
  command->add_option("--out", arguments->folder, "Folder for the layout; default: out/<name of the input>")
      ->type_name("DIR");
  command->add_flag("--quiet", arguments->quiet, "Print only warnings and errors");
  command
      ->add_option("--time-limit", arguments->time_limit,
                   "End within this time with the best layout so far; default: the end of the Slurm job")
      ->type_name("LIMIT");
  command
      ->add_option("--silence-s", arguments->silence_s,
                   "A rank that sends no heartbeat for this time is lost: the search ends with the best layout so far")
      ->check(CLI::Range(1.0, 1e6))
      ->capture_default_str()
      ->type_name("SECONDS");
  command->callback([arguments, &selected] {
    selected.run_on_all_ranks = [arguments](comm::Communicator& ranks) { return nest_on_all_ranks(*arguments, ranks); };
  });
}

}  // namespace tessera::cli
