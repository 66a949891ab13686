#include "run/campaign_run.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <optional>

#include "comm/stop_signals.h"
#include "core/base/count_text.h"
#include "core/base/error.h"
#include "files/output_lock.h"
#include "job/job_entry.h"
#include "job/job_file.h"
#include "job/pieces/variations.h"
#include "job/quality_word.h"
#include "result/card_input.h"
#include "result/collage_files.h"
#include "result/folder/finished_result.h"
#include "result/folder/result_file.h"
#include "run/collage_problem.h"
#include "run/collage_run.h"
#include "run/results/ranking_run.h"
#include "terminal/terminal.h"
#include "text/number_text.h"

namespace tessera {
namespace {

struct Task {
  Variation variation;
  std::string folder;
  std::optional<CollageEnd> end;  // the end of an earlier run; empty: the collage is to be made
};

std::string campaign_folder(const CampaignArguments& arguments) {
  if (!arguments.out.empty()) return arguments.out;
  return "out/" + std::filesystem::path(arguments.job).stem().string() + "-campaign";
}

/// The job as a finished result in the folder would hold it; `found` is the job there. It reads library and canvas, which
/// may be gone by now, only where all else agrees.
Job effective_job(const Job& job, const Job& found) {
  if (!quality_waits_for_sizes(job)) return job;
  Job as_found = job;
  as_found.quality = found.quality;
  as_found.settings.improve = found.settings.improve;
  if (!result_differences(found, as_found).empty()) return as_found;
  try {
    return CanvasProblem(job).job();
  } catch (const InputError&) {
    return as_found;
  }
}

/// How the run in this folder ended, if its collage is computed and drawn. Throws InputError where the folder holds the
/// result of another job, which would be lost.
std::optional<CollageEnd> earlier_end(const std::string& folder, const Job& job) {
  const EarlierResult earlier = find_earlier_result(folder);
  if (!earlier.whole || !is_finished_result_of(earlier, effective_job(job, earlier.whole->job)) ||
      !earlier.whole->drawn)
    return {};
  return end_of_finished(earlier.whole->manifest);
}

/// Makes all tasks. It reads all jobs before the first is begun, so that a mistake in the last one shows at once.
std::vector<Task> tasks_of(const CampaignArguments& arguments) {
  std::vector<Task> tasks;
  for (Variation& variation : make_variations(arguments.seeds, arguments.sets)) {
    const Job job = load_job(arguments.job, variation.overrides);
    const std::string folder = (std::filesystem::path(campaign_folder(arguments)) / variation.name).string();
    tasks.push_back({std::move(variation), folder, earlier_end(folder, job)});
  }
  return tasks;
}

/// The results in a campaign's folder, by name, but for those that refining made of others.
std::vector<std::string> results_in(const std::string& folder) {
  std::vector<std::string> names;
  std::error_code error;  // where there is no folder, there are no results
  for (const auto& entry : std::filesystem::directory_iterator(folder, error)) {
    const std::string path = entry.path().string();
    if (!entry.is_directory(error) || !is_in_result(path, kManifestName)) continue;
    const EarlierResult found = find_earlier_result(path);
    if (found.whole && !found.whole->manifest.start.empty()) continue;
    names.push_back(entry.path().filename().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

/// Throws InputError where the folder holds results that this campaign does not make: the new ranking would leave them out.
void check_extends_what_is_there(const CampaignArguments& arguments, const std::vector<Task>& tasks) {
  std::vector<std::string> others = results_in(campaign_folder(arguments));
  std::erase_if(others, [&](const std::string& name) {
    return std::any_of(tasks.begin(), tasks.end(), [&](const Task& task) { return task.variation.name == name; });
  });
  if (others.empty()) return;
  const std::string more = others.size() > 1 ? " and " + count_text(others.size() - 1, "other") : "";
  throw InputError(campaign_folder(arguments) +
                   ": holds results that this campaign does not make: " + printable(others.front()) + more +
                   "; give --seeds and --set that make these, too, or another --out; tessera rank ranks any results");
}

/// Finds out, before hours of work, whether the folders can be made.
void check_can_be_made(const std::vector<Task>& tasks) {
  std::error_code error;
  for (const Task& task : tasks) {
    if (task.end || !std::filesystem::exists(task.folder, error)) continue;
    prepare_output_directory(task.folder);
    check_can_be_published(task.folder);
  }
}

/// Prints a list for scripts: one line for each collage, with tabs between state, folder and the values for --set.
void print_list(const std::vector<Task>& tasks) {
  for (const Task& task : tasks) {
    std::vector<std::string> cells = {task.end ? "finished" : "open", task.folder};
    cells.insert(cells.end(), task.variation.overrides.begin(), task.variation.overrides.end());
    print_cells(cells);
  }
}

/// The measures of a collage's card; empty where it has no card.
std::string measures_in(const std::string& folder) {
  try {
    const ResultCard card = read_card(folder);
    return fixed(100 * card.quality.coverage, 2) + " % covered, " + fixed(card.total_s, 1) + " s";
  } catch (const InputError& error) {
    return error.what();
  }
}

void print_result(const Task& task, CollageEnd end, std::size_t number, std::size_t of) {
  print_line("%zu/%zu  %s: %s%s%s", number, of, task.variation.name.c_str(), measures_in(task.folder).c_str(),
             end == CollageEnd::incomplete ? ", pieces are missing" : "", task.end ? ", finished before" : "");
  print_now();
}

/// The arguments for one collage. One that an earlier campaign left unfinished goes on from its checkpoint, or is drawn.
CollageArguments collage_of(const CampaignArguments& arguments, const Task& task) {
  CollageArguments collage;
  collage.job = arguments.job;
  collage.out = task.folder;
  collage.overrides = task.variation.overrides;
  collage.quiet = true;
  collage.resume = "auto";
  return collage;
}

/// Makes all collages and returns their common exit code. An incomplete collage ends none of the others, an interrupted one
/// ends the campaign.
int make_all(const CampaignArguments& arguments, const std::vector<Task>& tasks, comm::Communicator& ranks) {
  int exit_code = kDoneExitCode;
  for (std::size_t i = 0; i < tasks.size(); ++i) {
    if (tasks[i].end) remove_stale_lock(folder_lock_path(tasks[i].folder));  // of a campaign that was killed
    const CollageEnd end = tasks[i].end ? *tasks[i].end : run_collage(collage_of(arguments, tasks[i]), ranks);
    if (!is_finished(end)) return kUnfinishedExitCode;
    if (end == CollageEnd::incomplete) exit_code = kIncompleteExitCode;
    print_result(tasks[i], end, i + 1, tasks.size());
  }
  return comm::stop_signalled() ? kUnfinishedExitCode : exit_code;
}

}  // namespace

int run_campaign(const CampaignArguments& arguments, comm::Communicator& ranks) {
  if (ranks.size() > 1) {
    throw InputError("campaign: found " + std::to_string(ranks.size()) +
                     " ranks, allowed: 1; over more ranks slurm/campaign.sh makes an array of jobs");
  }
  const std::vector<Task> tasks = tasks_of(arguments);
  check_extends_what_is_there(arguments, tasks);
  if (arguments.list) {
    print_list(tasks);
    return 0;
  }
  prepare_output_directory(campaign_folder(arguments));
  const OutputLock lock(folder_lock_path(campaign_folder(arguments)), campaign_folder(arguments));
  check_can_be_made(tasks);
  check_ranking_can_be_written(campaign_folder(arguments));
  const int made = make_all(arguments, tasks, ranks);
  if (made == kUnfinishedExitCode) {
    print_message("unfinished: run the same command again to continue");
    return kUnfinishedExitCode;
  }
  RankingArguments ranking{.folders = {}, .out = campaign_folder(arguments), .weights = arguments.weights};
  for (const Task& task : tasks) ranking.folders.push_back(task.folder);
  const int ranked = run_ranking(ranking);
  return ranked == kDoneExitCode ? made : ranked;
}

}  // namespace tessera
