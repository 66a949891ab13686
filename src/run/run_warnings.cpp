#include "run/run_warnings.h"

#include <map>
#include <string>
#include <utility>

#include "job/job_tables.h"
#include "library/one_colour.h"
#include "run/messages/collage_warnings.h"
#include "run/messages/first_picture_warning.h"
#include "run/messages/place_advice.h"
#include "run/messages/written_keys.h"
#include "run/unplaced_pieces.h"

namespace tessera {
namespace {

bool relaxes(const CollageArguments& arguments) { return arguments.refined && arguments.refined->relaxes; }

/// The warning of keys that have no effect in this job. The user saw the warnings of a refined result when it was made, so
/// it is empty unless it says something new.
std::string idle_keys_warning_of(const CollageArguments& arguments, const Job& job) {
  const std::string warning = idle_keys_warning(job);
  if (arguments.refined && warning == idle_keys_warning(arguments.refined->whole.job)) return "";
  return warning;
}

std::string standing_warning_of(const CanvasProblem& problem) {
  if (problem.settings().wishes.given.empty()) return "";
  constexpr LibraryParts kOutlines{.outline = true, .field = false, .levels = 0, .artwork = false};
  std::map<ShapeId, Shape> read;
  const std::size_t rows = rows_of(problem.job(), "given").size();
  return standing_warning(
      problem.settings(), rows, problem.job().start.keep, problem.canvas(), [&](ShapeId id) -> const Shape& {
        const auto [at, is_new] = read.try_emplace(id);
        if (is_new) at->second = std::move(problem.library().read(index_of(id), index_of(id) + 1, kOutlines).front());
        return at->second;
      });
}

std::string unable_library_warning_of(const CollageArguments& arguments, const CanvasProblem& problem) {
  const std::string& image = problem.job().colour.image;
  const bool was_told = arguments.refined && arguments.refined->whole.job.colour.image == image;
  if (image.empty() || was_told) return "";
  return unable_library_warning(problem.job().colour, problem.library().size(), is_of_one_colour(problem.library()));
}

/// The warning of a drawing that is only an outline. Empty where only the room of removed pieces is filled, and for a
/// refined result, whose user saw the warning before.
std::string outline_alone_warning_of(const CollageArguments& arguments, const CanvasProblem& problem) {
  const bool is_part = problem.found().room_part < 1;
  return arguments.refined || is_part ? "" : outline_alone_warning(problem.job().canvas, problem.canvas());
}

}  // namespace

void warn_of_problem(const CollageArguments& arguments, const CollageInput& input, CollageJournal& journal) {
  const CanvasProblem& problem = input.problem;
  const Job& job = problem.job();
  journal.warn(replaced_result_warning(input.earlier, job));
  journal.warn(idle_keys_warning_of(arguments, job));
  if (!arguments.refined) journal.warn(decimal_comma_warning(job));
  if (!arguments.refined) journal.warn(first_picture_warning(job));
  journal.warn(unable_library_warning_of(arguments, problem));
  journal.warn(outline_alone_warning_of(arguments, problem));
  if (!arguments.refined) journal.warn(standing_warning_of(problem));  // a result's pieces lie as it put them
  if (relaxes(arguments)) journal.warn(idle_relaxing_warning(job.settings));
}

void warn_of_result(const CollageArguments& arguments, const CollageInput& input, const master::CollageResult& result,
                    const std::vector<MissingShape>& missing, CollageJournal& journal) {
  const CanvasProblem& problem = input.problem;
  const CollageSettings& settings = problem.settings();
  const std::vector<GivenPiece>& removed = problem.job().start.removed;
  const std::size_t given = settings.wishes.given.size();
  const bool drawn_sizes = has_drawn_sizes(WrittenKeys(problem.job()));
  journal.warn(unplaced_warning(input, result, missing, arguments.refined.get()));
  journal.warn(empty_regions_warning(problem, result));
  journal.warn(never_fitting_warning(problem, result));
  journal.warn(used_up_warning(settings.pieces, drawn_sizes, problem.canvas(), result));
  if (relaxes(arguments)) journal.warn(nothing_gained_warning(settings, result));
  journal.warn(empty_room_warning(removed.size(), given, result));
  if (!removed.empty())
    journal.warn(come_back_warning(removed, given, problem.canvas(), result, problem.library().variant_of()));
}

}  // namespace tessera
