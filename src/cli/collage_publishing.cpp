#include "cli/collage_publishing.h"

#include "io/job/job_library.h"
#include "io/result/collage_files.h"
#include "io/result/piece_colours.h"
#include "io/result/piece_deformation.h"
#include "io/result/placed_pieces.h"
#include "io/result/tones.h"

namespace tessera::cli {

bool leaves_older_result(const CollageInput& input, const master::CollageResult& result) {
  return result.unfinished && result.placements.empty() && input.earlier.finished();
}

std::string publish(const CollageInput& input, const master::CollageResult& result,
                    const std::vector<io::MissingShape>& missing, const RankStatistics& ranks,
                    const io::RunRecord& record, const CollageCheckpoints& checkpoints) {
  io::CollageReport report;
  report.job = &input.job;
  report.canvas = &input.canvas;
  report.placements = io::as_written(result.placements);  // as tessera draw knows them when it gives other colours
  report.missing = missing;
  report.statistics = result.statistics;
  report.ranks = ranks;
  report.record = record;
  const io::LibraryParts parts{.outline = true, .field = true, .levels = 0, .artwork = true, .original = false};
  report.shapes = io::read_placed_shapes(input.library, report.placements, parts);
  report.names_like_patterns = io::names_like_patterns(input.library, input.job);
  const ColourWish& colour = input.job.settings.colour;
  if (colour.target) report.covered = io::covered_colours(report, *colour.target);
  if (io::draws_palette(input.job.colour, input.library)) report.colours = io::piece_colours(report, input.palette);
  report.placements = result.placements;
  const std::vector<StyleFeatures> styles = input.library.styles();
  for (const Placement& placement : report.placements) report.styles.push_back(styles[index_of(placement.shape)]);
  if (!result.unfinished && io::deforms(input.job)) io::deform_pieces(report);
  const std::string card = io::publish_result(input.folder, report, input.origin, !result.unfinished);
  if (result.unfinished) {
    checkpoints.require_one();
  } else {
    checkpoints.remove();
  }
  return card;
}

}  // namespace tessera::cli
