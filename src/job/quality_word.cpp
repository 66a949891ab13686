#include "job/quality_word.h"

#include <algorithm>
#include <cmath>

#include "job/job_keys.h"

namespace tessera {
namespace {

// 300 trials for a canvas of 1000 x 1000 px with pieces of 30 to 150 px, the numbers of the demo's job.
constexpr double kGoodTrialsPerPiece = 300 * 30 * 150 / 1e6;
// Coverage of that job: 88.2 % without trials, 90.3 % with 300, 91.1 % with 2,400.
constexpr double kBestTrialsPerPiece = 8 * kGoodTrialsPerPiece;

/// The sizes of [pieces], without those of single shapes. With fit = "all", drawn sizes are known only from the shapes.
Interval sizes_of(const Job& job) {
  const PieceSettings& pieces = job.settings.pieces;
  if (job.drawn_sizes && pieces.fit_all) return {pieces.min_scale_px, pieces.max_scale_px};
  Interval sizes = pieces.poses().scale_px.front();
  for (const Interval& scale_px : pieces.poses().scale_px) {
    sizes.min = std::min(sizes.min, scale_px.min);
    sizes.max = std::max(sizes.max, scale_px.max);
  }
  return sizes;
}

/// The number of pieces, if all had the geometric mean of the smallest and largest size and covered the rectangle or
/// box.
double expected_pieces(const CanvasSpec& canvas, const Interval& scale_px) {
  return double(canvas.width_px) * canvas.height_px / (double(scale_px.min) * scale_px.max);
}

/// Rounded to two significant digits: the estimate is no better.
double rounded(double number) {
  double unit = 1;
  while (std::round(number / unit) >= 100) unit *= 10;
  return std::round(number / unit) * unit;
}

int trials(QualityWord word, double pieces) {
  if (word == QualityWord::draft) return 0;
  const double per_piece = word == QualityWord::best ? kBestTrialsPerPiece : kGoodTrialsPerPiece;
  return int(std::clamp(rounded(per_piece * pieces), 1., find_job_key("improve", "trials")->max));
}

}  // namespace

bool quality_waits_for_sizes(const Job& job) {
  return job.settings.pieces.fit_all && (job.quality == QualityWord::good || job.quality == QualityWord::best);
}

void set_improving_by_quality(Job& job, double size_factor) {
  if (job.quality == QualityWord::none) return;
  const double pieces = expected_pieces(job.canvas, sizes_of(job)) / (size_factor * size_factor);
  job.settings.improve.trials = trials(job.quality, pieces);
  job.settings.improve.seconds = 0;
  job.quality = QualityWord::none;
}

}  // namespace tessera
