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
    "what 1 unit was taken as: 1/96 inch, 1 mm. --demand finds a piece by its id, or by its file's name where it is "
    "alone "
    "there.\nDIR has layout.svg and .dxf in mm for the cutter,\n"
    "layout.png to look at, layout.json, card.txt. Pieces that find no place are named, and the exit code is 3. After\n"
    "--time-limit, Ctrl-C, SIGTERM or a lost rank the best layout so far is written: then it depends on time which one "
    "that is.";

}  // namespace

// The options, one in a row of the table.
void add_nest_command(CLI::App& app, Command& selected) {
  const auto arguments = std::make_shared<NestArguments>();
  CLI::App* command = app.add_subcommand("nest", "Lay shapes of fixed sizes densely on a strip or on sheets");
  command->footer(kNestExamples);
  command->add_option("INPUT", arguments->input, "What is laid")->required()->type_name("PATH");
  command
      ->add_option("--strip", arguments->strip_mm,
                   "A strip of that height, as short as it can be; default: the instance's")
      ->type_name("MM");
  add_list_option(*command, "--sheet", arguments->sheet_mm,
                  "Sheets of that size, as few as are needed; default: the instance's bin",
                  {.type_name = "W,H", .count = 2});
  add_list_option(*command, "--angles", arguments->angles_deg,
                  "By which pieces may be turned, degrees; default: the instance's, or 0,90,180,270",
                  {.type_name = "DEG,..."});
  command
      ->add_option("--demand", arguments->demands,
                   "How many of the shapes of that name, which may have * and ?; default: 1, or the instance's")
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
      ->type_name("NAME=COUNT");
  command
      ->add_option("--leave-out", arguments->left_out,
                   "An element of an SVG that is not cut, by its id, as the rectangle of a bed; what is in it is")
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
      ->type_name("NAME");
  command
      ->add_option(
          "--dpi", arguments->px_per_inch,
          "px of an SVG that make an inch: 90 as Inkscape wrote them up to 0.91, 72 as Illustrator; default: 96")
      ->check(CLI::Range(1.0, 10'000.0))
      ->type_name("PX");
  command->add_option("--spacing", arguments->spacing_mm, "Least distance between pieces, mm")->capture_default_str();
  command
      ->add_option(
          "--effort", arguments->effort,
          "Seconds, half a minute, or minutes for 50 simple pieces on two cores; draft and good are two searches, best "
          "is four: more cores do not help")
      ->check(CLI::IsMember({"draft", "good", "best"}))
      ->capture_default_str();
  command->add_option("--seed", arguments->seed, "Another seed, another layout")->capture_default_str();
  command->add_option("--out", arguments->folder, "Where the layout goes; default: out/<name of the input>")
      ->type_name("DIR");
  command->add_flag("--quiet", arguments->quiet, "Warnings and errors only");
  command
      ->add_option("--time-limit", arguments->time_limit,
                   "End by then with the best layout so far; default: the end of the Slurm job")
      ->type_name("LIMIT");
  command
      ->add_option("--silence-s", arguments->silence_s,
                   "A rank that has not been heard of for so long is lost: the search ends with the best layout so far")
      ->check(CLI::Range(1.0, 1e6))
      ->capture_default_str()
      ->type_name("SECONDS");
  command->callback([arguments, &selected] {
    selected.run_on_all_ranks = [arguments](comm::Communicator& ranks) { return nest_on_all_ranks(*arguments, ranks); };
  });
}

}  // namespace tessera::cli
