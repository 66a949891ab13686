#include "run/collage_publishing.h"

#include "job/pieces/job_library.h"
#include "render/piece_colours.h"
#include "render/piece_deformation.h"
#include "render/pieces/tones.h"
#include "result/collage_files.h"
#include "result/placed_pieces.h"

namespace tessera {

bool leaves_older_result(const CollageInput& input, const master::CollageResult& result) {
  return result.unfinished && result.placements.empty() && input.earlier.finished();
}

std::string publish(const CollageInput& input, const master::CollageResult& result,
                    const std::vector<MissingShape>& missing, const RankStatistics& ranks, const RunRecord& record,
                    const CollageCheckpoints& checkpoints) {
  const CanvasProblem& problem = input.problem;
  CollageReport report;
  report.job = &problem.job();
  report.canvas = &problem.canvas();
  report.placements = result.placements;
  report.missing = missing;
  report.statistics = result.statistics;
  report.ranks = ranks;
  report.record = record;
  const LibraryParts parts{.outline = true, .field = true, .levels = 0, .artwork = true, .original = false};
  report.shapes = read_placed_shapes(problem.library(), report.placements, parts);
  report.names_like_patterns = names_like_patterns(problem.library(), problem.job());
  const ColourWish& colour = problem.settings().colour;
  const std::vector<Placement> written = as_written(result.placements);  // as tessera draw knows them
  if (colour.target) report.covered = covered_colours(written, report.shapes, *colour.target);
  if (draws_palette(problem.job().colour, problem.library()))
    report.colours = piece_colours(report, written, problem.palette());
  const std::vector<StyleFeatures> styles = problem.library().styles();
  for (const Placement& placement : report.placements) report.styles.push_back(styles[index_of(placement.shape)]);
  if (!result.unfinished && deforms(problem.job())) deform_pieces(report);
  const std::string card = publish_result(input.folder, report, input.origin, !result.unfinished);
  if (result.unfinished) {
    checkpoints.require_one();
  } else {
    checkpoints.remove();
  }
  return card;
}

}  // namespace tessera
