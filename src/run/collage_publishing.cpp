#include "run/collage_publishing.h"

#include <algorithm>

#include "job/pieces/job_library.h"
#include "job/pieces/shape_group.h"
#include "job/pieces/start_pieces.h"
#include "job/pieces/wished_sizes.h"
#include "render/piece_colours.h"
#include "render/piece_deformation.h"
#include "render/pieces/tones.h"
#include "result/collage_files.h"
#include "result/placed_pieces.h"

namespace tessera {
namespace {

std::vector<bool> locked_for_good(const Wishes& wishes, std::size_t pieces) {
  std::vector<bool> locked(pieces, false);
  for (std::size_t i = 0; i < std::min(wishes.locked(), pieces); ++i) locked[i] = wishes.given[i].for_good;
  return locked;
}

/// The report of the finished loop, without what only pictures show.
CollageReport report_of(const CanvasProblem& problem, const master::CollageResult& result) {
  CollageReport report;
  report.output = problem.output();
  report.canvas = &problem.canvas();
  report.placements = result.placements;
  report.statistics = result.statistics;
  const LibraryParts parts{.outline = true, .field = true, .levels = 0, .artwork = true, .original = false};
  report.shapes = read_placed_shapes(problem.library(), report.placements, parts);
  const std::vector<std::string> groups =
      shape_groups(problem.job(), report.shapes.names(), names_like_patterns(problem.library(), problem.job()));
  report.groups = of_placements(groups, report.shapes, report.placements);
  report.locked = locked_for_good(problem.settings().wishes, report.placements.size());
  const std::vector<StyleFeatures> styles = problem.library().styles();
  for (const Placement& placement : report.placements) report.styles.push_back(styles[index_of(placement.shape)]);
  return report;
}

/// Adds the colours of the drawn pieces. They are computed from the poses in the written file, like tessera draw does.
void add_colours(const CanvasProblem& problem, CollageReport& report) {
  const std::vector<Placement> written = as_written(report.placements);
  const CollageSettings& settings = problem.settings();
  if (settings.colour.target) report.covered = covered_colours(written, report.shapes, *settings.colour.target);
  if (draws_palette(problem.job().colour, problem.library()))
    report.colours = piece_colours(report, written, problem.palette(), settings.pieces.padding_px);
}

ResultSource source_of(const CollageInput& input) {
  const Job& job = input.problem.job();
  return {.origin = input.origin,
          .library = library_text(job),
          .start = start_file(job),
          .start_digest = job.start.digest,
          .sizes = wished_sizes(job),
          .card = {.padding_px = job.settings.pieces.padding_px, .trials = job.settings.improve.trials},
          .shown_png = job.shown_png};
}

}  // namespace

bool leaves_older_result(const CollageInput& input, const master::CollageResult& result) {
  return result.unfinished && result.placements.empty() && input.earlier.finished();
}

std::string publish(const CollageInput& input, const master::CollageResult& result,
                    const std::vector<MissingShape>& missing, const RankStatistics& ranks, const RunRecord& record,
                    const CollageCheckpoints& checkpoints) {
  const CanvasProblem& problem = input.problem;
  CollageReport report = report_of(problem, result);
  report.missing = missing;
  report.ranks = ranks;
  report.record = record;
  add_colours(problem, report);
  const bool deforms = problem.settings().deform.kind != DeformKind::none;
  if (!result.unfinished && deforms) deform_pieces(report, problem.settings());
  const std::string card = publish_result(input.folder, report, source_of(input), !result.unfinished);
  if (result.unfinished) {
    checkpoints.require_one();
  } else {
    checkpoints.remove();
  }
  return card;
}

}  // namespace tessera
