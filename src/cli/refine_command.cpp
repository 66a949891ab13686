#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "cli/collage_options.h"
#include "cli/commands.h"
#include "cli/refined_result.h"
#include "io/job/job_keys.h"

namespace tessera::cli {
namespace {

constexpr const char* kExamples =
    "Examples:\n"
    "  tessera refine out/animals --relax                 all pieces move once: out/animals-relaxed\n"
    "  tessera refine out/animals --relax --trials 300    then pieces are exchanged, go out and others come in\n"
    "  tessera refine out/animals --relax --out denser --set pieces.padding_px=0\n"
    "  mpirun -n 3 tessera refine out/animals --relax     rank 0 is the master, the others are workers\n"
    "RESULT stays as it is. Its job is run again from its pieces, which may move but for those of [[given]] and those\n"
    "that were locked. What still fits is placed before and after, so there may be more pieces; a job with a limit of\n"
    "[stop] gets none beyond it, or beyond those of RESULT, and exchanges none. What comes of a trial is kept where "
    "it\n"
    "covers more, what pieces cover twice and what copies cost (objective.repetition_exponent) taken off; else pieces\n"
    "stay where they are. --relax brings something where sizes may change, the largest is at most five times the\n"
    "smallest, and neither colour.image nor pieces.size_map is given; elsewhere a warning says why not. [[regions]]\n"
    "relax one after the other, each in a trial of its own.\n"
    "The library and the canvas must be those that RESULT was made from. --resume, --time-limit, signals and exit\n"
    "codes are as in tessera collage.";

struct RefineArguments {
  std::string result;
  bool relax = false;
  int trials = 0;  // 0: as few as the action needs
  CollageArguments collage;
};

/// What an action makes of a result: where it goes, and which keys differ from those of its job.
struct Action {
  const char* suffix;
  std::vector<std::string> keys;
};

Action action_of(const RefineArguments& arguments, const RefinedResult& result) {
  return {"-relaxed", relaxing_keys(result, arguments.trials)};
}

/// The result's job, run again. What the command line sets wins, but not over where it starts.
CollageArguments collage_of(const RefineArguments& arguments) {
  check_overrides(arguments.collage.overrides);
  const auto result = std::make_shared<const RefinedResult>(read_refined_result(arguments.result));
  const Action action = action_of(arguments, *result);
  CollageArguments collage = arguments.collage;
  collage.refined = result;
  collage.job = (std::filesystem::path(result->folder) / "job.toml").string();
  if (collage.out.empty()) collage.out = folder_beside(result->folder, action.suffix);
  check_other_folder(*result, collage.out);
  std::vector<std::string>& keys = collage.overrides;
  keys.insert(keys.begin(), action.keys.begin(), action.keys.end());
  for (const std::string& key : starting_keys(*result)) keys.push_back(key);
  return collage;
}

/// Rank 0 alone reads the result; the workers get its job from there as of any collage.
int run(const RefineArguments& arguments, comm::Communicator& ranks) {
  return collage_exit_code(ranks.rank() == 0 ? collage_of(arguments) : arguments.collage, ranks);
}

void check_has_action(const RefineArguments& arguments) {
  if (!arguments.relax) throw CLI::RequiredError("What to do with RESULT (--relax)");
}

}  // namespace

void add_refine_command(CLI::App& app, Command& selected) {
  const auto arguments = std::make_shared<RefineArguments>();
  CLI::App* refine = app.add_subcommand("refine", "Improve a finished result without making it anew");
  refine->footer(kExamples);
  refine->add_option("RESULT", arguments->result, "The folder of the result")->required()->type_name("DIR");
  CLI::Option* relax =
      refine->add_flag("--relax", arguments->relax, "All pieces move, turn and grow together into the gaps");
  const io::JobKey& trials = *io::find_job_key("improve", "trials");
  refine
      ->add_option("--trials", arguments->trials,
                   "Of improving, the first of which relaxes (improve.trials); default: 1, or one for each region")
      ->type_name("N")
      ->check(CLI::Range(1, int(trials.max)))
      ->needs(relax);
  add_collage_options(*refine, arguments->collage, "<RESULT>-relaxed");
  refine->callback([arguments, &selected] {
    check_has_action(*arguments);
    selected.run_on_all_ranks = [arguments](comm::Communicator& ranks) { return run(*arguments, ranks); };
  });
}

}  // namespace tessera::cli
