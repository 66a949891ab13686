#include "cli/collage_options.h"
#include "terminal/terminal.h"

namespace tessera::cli {
namespace {

std::string how_to_go_on(const CollageArguments& arguments) {
  std::string text = "unfinished: go on with the same command and --resume";
  if (arguments.restart) text += " instead of --restart";
  if (arguments.resume == "previous") text += " instead of --resume=previous";
  if (arguments.resume == "auto") text = "unfinished: the same command goes on with it";
  return text;
}

std::string draws_so_far(const CollageArguments& arguments) {
  return "; tessera draw " + output_folder(arguments) + " draws what is placed so far";
}

std::string older_stays(const CollageArguments& arguments) {
  return "; nothing is placed yet, the finished result in " + output_folder(arguments) +
         " is still that of the run before";
}

}  // namespace

void add_collage_options(CLI::App& command, CollageArguments& arguments, const std::string& default_out) {
  command.add_option("-o,--out", arguments.out, "Folder for the result; default: " + default_out)->type_name("DIR");
  command.add_option("--set", arguments.overrides, "Use this value instead of the job file's; may be repeated")
      ->type_name("SECTION.KEY=VALUE")
      ->allow_extra_args(false)
      ->take_all();
  command.add_flag("--quiet", arguments.quiet, "Print neither progress nor the quality card, only warnings");
  CLI::Option* resume =
      command
          .add_flag("--resume{latest}", arguments.resume,
                    "Continue from DIR/checkpoint.h5; --resume=previous: from DIR/checkpoint.previous.h5; "
                    "--resume=auto: from a checkpoint if there is one, else start")
          ->check(CLI::IsMember({"latest", "previous", "auto"}));
  command.add_flag("--restart", arguments.restart, "Remove the checkpoints in DIR and start again")->excludes(resume);
  command
      .add_option_function<std::string>(
          "--time-limit", [&arguments](const std::string& limit) { arguments.time_limit = limit; },
          "Stop early enough to write all files within this time; default: the end of the Slurm job")
      ->type_name("LIMIT");
}

int collage_exit_code(const CollageArguments& arguments, comm::Communicator& ranks) {
  switch (run_collage(arguments, ranks)) {
    case CollageEnd::finished: return kDoneExitCode;
    case CollageEnd::incomplete: return kIncompleteExitCode;
    case CollageEnd::unfinished: print_message(how_to_go_on(arguments) + draws_so_far(arguments)); break;
    case CollageEnd::nothing_placed: print_message(how_to_go_on(arguments) + older_stays(arguments)); break;
    case CollageEnd::not_begun:
      print_message("unfinished, before the first round: the same command starts again");
      break;
    case CollageEnd::not_drawn:
      print_message("collage finished, drawing interrupted: tessera draw " + output_folder(arguments) + " goes on");
      break;
  }
  return kUnfinishedExitCode;
}

}  // namespace tessera::cli
