#include <algorithm>
#include <filesystem>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "cli/collage_options.h"
#include "cli/commands.h"
#include "cli/erased_choice.h"
#include "core/base/error.h"
#include "files/output_folder.h"
#include "files/output_lock.h"
#include "job/job_keys.h"
#include "program/list_option.h"
#include "render/collage_sheet.h"
#include "result/marks_file.h"
#include "result/placed_pieces.h"
#include "run/refined_result.h"
#include "run/results/ranking_run.h"
#include "terminal/terminal.h"

namespace tessera::cli {
namespace {

constexpr const char* kRefineExamples =
    "Examples:\n"
    "  tessera refine out/animals --relax                 all pieces move once: out/animals-relaxed\n"
    "  tessera refine out/animals --relax --trials 300    then pieces are exchanged, too\n"
    "  tessera refine out/animals --relax --out denser --set pieces.padding_px=0\n"
    "  tessera refine out/animals --deform                gaps close: out/animals-deformed; limits: [deform] of a job\n"
    "  tessera refine out/animals --pieces 3,17           these two are replaced: out/animals-erased\n"
    "  tessera refine out/animals --box 200,300,150,100   all pieces with their centre in it\n"
    "  tessera refine out/animals --erase scribble.png    the pieces that it touches; drawn on a transparent page "
    "over\n"
    "                                                     collage.png, or painted over a copy of that\n"
    "  tessera refine out/animals --swap 12 --set seed=7  another drawing: out/animals-swapped\n"
    "  tessera refine out/animals --box 200,300,150,100 --variants 8\n"
    "                                                     out/animals-variants/seed_1 and so on, and a sheet of them\n"
    "  tessera refine out/animals --marks marks.json      as marked on out/animals/report.html, and saved there\n"
    "  mpirun -n 3 tessera refine out/animals --relax     rank 0 is the master, the others are workers\n"
    "RESULT itself is not changed. Pieces have the numbers of \"index\" in pieces.geojson, from 0; output.labels draws "
    "a map\n"
    "of them. Locked pieces ([[given]], --lock) stay where they are.\n"
    "If pieces are removed, all others stay exactly where they are, and only the room of the removed ones is filled;\n"
    "another seed gives another filling. A removed drawing does not come back to its old place, unless no other "
    "drawing may\n"
    "come in; a warning says so. Improving gets a part of improve.trials: the room's part of the canvas.\n"
    "--relax: the job runs again from the pieces, which may move. Pieces that still fit are placed before and after, "
    "so\n"
    "there may be more pieces. With a limit in [stop] no piece is added beyond it, or beyond the number in RESULT, and "
    "no\n"
    "piece is exchanged. The outcome of a trial is kept if it covers more, after subtracting area covered twice and "
    "the\n"
    "cost of copies (objective.repetition_exponent); otherwise pieces stay where they are. --relax helps if sizes may\n"
    "change, the largest is at most five times the smallest, and neither colour.image nor pieces.size_map is given;\n"
    "otherwise a warning says why not. [[regions]] relax one after the other, each in a trial of its own.\n"
    "The library and the canvas must be those that RESULT was made from. --resume, --time-limit, signals and exit "
    "codes are\n"
    "as in tessera collage.";

struct RefineArguments {
  std::string result;
  bool relax = false;
  std::string deform;  // the kind of deformation; empty: none
  EraseArguments erase;
  std::string marks;  // a file with pieces to erase or swap, and to lock; empty: none
  std::vector<int> locked;
  int trials = 0;    // 0: as few as the action needs
  int variants = 0;  // 0: one result
  CollageArguments collage;
};

/// The action on a result: the suffix of its folder, and the keys that differ from the result's job.
struct Action {
  const char* suffix;
  std::vector<std::string> keys;
};

std::vector<std::string> names_of(const std::vector<int>& pieces, const std::vector<PlacedPiece>& all) {
  std::set<std::string> names;
  for (const int i : pieces) names.insert(all[std::size_t(i)].shape);
  return {names.begin(), names.end()};
}

/// The action that the options ask for. Changes of single pieces are noted in `result`.
Action action_of(const RefineArguments& arguments, const std::string& job, RefinedResult& result) {
  const std::vector<PlacedPiece> all = read_placed_pieces(result.folder);
  result.locked = piece_numbers("--lock", arguments.locked, all.size());
  result.relaxes = arguments.relax;
  if (arguments.relax) return {"-relaxed", relaxing_keys(result, arguments.trials)};
  if (!arguments.deform.empty()) {
    return {arguments.deform == "capped" ? "-deformed" : "-voronoi", deforming_keys(result, arguments.deform)};
  }
  check_can_be_erased(result, all);
  const EraseArguments& erase = arguments.erase;
  result.erased = erased_pieces(erase, result.folder, load_job(job, arguments.collage.overrides), all);
  if (!arguments.collage.quiet) {
    print_line("%zu of %zu %s", result.erased.size(), all.size(), all.size() == 1 ? "piece goes" : "pieces go");
  }
  if (!erase.swapped.empty()) result.not_anew = names_of(result.erased, all);
  return {erase.swapped.empty() ? "-erased" : "-swapped", erasing_keys()};
}

/// The arguments with the pieces of the file of marks.
RefineArguments with_marks(RefineArguments arguments, const RefinedResult& result) {
  if (arguments.marks.empty()) return arguments;
  Marks marks = read_marks(arguments.marks, result.whole.manifest.pieces_digest);
  switch (marks.action) {
    case Marks::Action::erase: arguments.erase.pieces = std::move(marks.pieces); break;
    case Marks::Action::swap: arguments.erase.swapped = std::move(marks.pieces); break;
    case Marks::Action::relax: arguments.relax = true; break;
  }
  arguments.locked.insert(arguments.locked.end(), marks.locked.begin(), marks.locked.end());
  return arguments;
}

/// The arguments that run the result's job again. Overrides of the command line win, except over the starting pieces.
CollageArguments collage_of(const RefineArguments& arguments) {
  check_overrides(arguments.collage.overrides);
  const auto result = std::make_shared<RefinedResult>(read_refined_result(arguments.result));
  CollageArguments collage = arguments.collage;
  collage.job = (std::filesystem::path(result->folder) / "job.toml").string();
  const Action action = action_of(with_marks(arguments, *result), collage.job, *result);
  collage.refined = result;
  const char* suffix = arguments.variants > 0 ? "-variants" : action.suffix;
  if (collage.out.empty()) collage.out = folder_beside(result->folder, suffix);
  check_other_folder(*result, collage.out);
  std::vector<std::string> keys = starting_keys(*result);
  keys.insert(keys.end(), action.keys.begin(), action.keys.end());
  collage.overrides.insert(collage.overrides.begin(), keys.begin(), keys.end());
  return collage;
}

/// Makes the variants one after the other, with the job's seed and those after it, each in a folder of its own; then
/// ranks them. Unfinished variants continue. Runs on one rank only, as workers serve a single run.
int make_variants(const RefineArguments& arguments, comm::Communicator& ranks) {
  if (ranks.size() > 1) {
    throw InputError(
        "--variants: found " + std::to_string(ranks.size()) +
        " ranks, allowed: 1; over more ranks refine without it, then slurm/campaign.sh with the job.toml of " +
        "the new result makes an array of jobs");
  }
  const CollageArguments all = collage_of(arguments);
  const std::uint64_t first_seed = load_job(all.job, all.overrides).settings.seed;
  const OutputFolder folder(all.out);
  const OutputLock lock(folder_lock_path(all.out), all.out);
  RankingArguments ranking{.folders = {}, .out = all.out, .weights = {}};
  bool all_complete = true;
  for (int k = 0; k < arguments.variants; ++k) {
    const std::string seed = std::to_string(first_seed + std::uint64_t(k));
    CollageArguments one = all;
    one.quiet = true;
    one.out = (std::filesystem::path(all.out) / ("seed_" + seed)).string();
    one.overrides.push_back("seed=" + seed);
    if (one.resume.empty() && !one.restart) one.resume = "auto";
    ranking.folders.push_back(one.out);
    const CollageEnd end = run_collage(one, ranks);
    all_complete = all_complete && end != CollageEnd::incomplete;
    if (is_finished(end)) continue;
    print_message(std::string("unfinished: the same command") + (one.restart ? " without --restart" : "") +
                  " goes on where this one was");
    return kUnfinishedExitCode;
  }
  const int exit_code = run_ranking(ranking);
  return exit_code == kDoneExitCode && !all_complete ? kIncompleteExitCode : exit_code;
}

/// Only rank 0 reads the result; it sends the job to the workers, as any collage.
int run(const RefineArguments& arguments, comm::Communicator& ranks) {
  if (arguments.variants > 0) return ranks.rank() == 0 ? make_variants(arguments, ranks) : 0;
  return collage_exit_code(ranks.rank() == 0 ? collage_of(arguments) : arguments.collage, ranks);
}

void check_has_action(const RefineArguments& arguments) {
  if (!arguments.deform.empty() && arguments.variants > 0)
    throw CLI::ValidationError("--variants",
                               "found with --deform, which no seed changes; allowed with the other actions");
  if (arguments.relax || !arguments.deform.empty() || arguments.erase.any() || !arguments.marks.empty()) return;
  throw CLI::RequiredError("What to do with RESULT (--relax, --deform, --pieces, --box, --erase, --swap or --marks)");
}

/// Adds the actions; at most one can be given.
void add_actions(CLI::App& refine, RefineArguments& arguments) {
  CLI::Option_group* actions = refine.add_option_group("Actions");
  actions->require_option(0, 1);
  actions->add_flag("--relax", arguments.relax, "All pieces move, turn and grow together into the gaps");
  actions
      ->add_flag(
          "--deform{capped}", arguments.deform,
          "Deform outlines and drawings a little to close gaps and overlaps; --deform=voronoi: as far as there is "
          "something to fill")
      ->check(CLI::IsMember({"capped", "voronoi"}));
  const ListOption pieces{.type_name = "N,N.."};
  add_list_option(*actions, "--pieces", arguments.erase.pieces, "Remove these pieces, and fill their room again",
                  pieces);
  add_list_option(
      *actions, "--box", arguments.erase.box_px,
      "Remove pieces with their centre in this rectangle, px of the canvas (canvas.size_px), not of collage.png",
      {.type_name = "X,Y,W,H", .count = 4});
  actions
      ->add_option("--erase", arguments.erase.mask,
                   "Remove pieces that this drawing touches; it is laid over the canvas: an SVG or an image")
      ->type_name("MASK");
  add_list_option(*actions, "--swap", arguments.erase.swapped,
                  "Remove these pieces, and fill their room with other "
                  "drawings",
                  pieces);
  actions
      ->add_option("--marks", arguments.marks,
                   "Remove, swap, relax and lock pieces as they were marked on the result's page (tessera report)")
      ->type_name("FILE");
}

}  // namespace

void add_refine_command(CLI::App& app, Command& selected) {
  const auto arguments = std::make_shared<RefineArguments>();
  CLI::App* refine = app.add_subcommand("refine", "Improve or change a finished result");
  refine->footer(kRefineExamples);
  refine->add_option("RESULT", arguments->result, "The folder of the result")->required()->type_name("DIR");
  add_actions(*refine, *arguments);
  add_list_option(*refine, "--lock", arguments->locked,
                  "Lock these pieces: they stay where they are, now and in "
                  "later refinements",
                  {.type_name = "N,N.."});
  const JobKey& trials = *find_job_key("improve", "trials");
  refine
      ->add_option("--trials", arguments->trials,
                   "Number of improvement trials (improve.trials), of which the first one relaxes; default: 1, or "
                   "one for each region")
      ->type_name("N")
      ->check(CLI::Range(1, int(trials.max)))
      ->needs(refine->get_option("--relax"));
  refine
      ->add_option("--variants", arguments->variants,
                   "Make this many results with different seeds, beginning with the job's seed, in folders of DIR, "
                   "and rank them (tessera rank)")
      ->type_name("N")
      ->check(CLI::Range(2, int(kMaxSheetCollages)));
  refine->add_flag("--early", arguments->collage.early,
                   "Also write pieces.geojson once the room is filled, before it is improved: for a reader who waits");
  add_collage_options(*refine, arguments->collage,
                      "<RESULT>-relaxed, -deformed, -voronoi, -erased, -swapped or -variants");
  refine->callback([arguments, &selected] {
    check_has_action(*arguments);
    selected.run_on_all_ranks = [arguments](comm::Communicator& ranks) { return run(*arguments, ranks); };
  });
}

}  // namespace tessera::cli
