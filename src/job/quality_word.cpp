#include "job/quality_word.h"

#include <algorithm>
#include <cmath>

#include "job/job_keys.h"

namespace tessera {
namespace {

// 300 trials for 1000 x 1000 px of pieces of 30 to 150 px: what the demo's job was tuned with.
constexpr double kGoodTrialsPerPiece = 300 * 30 * 150 / 1e6;
// Coverage of that job: 88.2 % without trials, 90.3 % with 300, 91.1 % with 2,400.
constexpr double kBestTrialsPerPiece = 8 * kGoodTrialsPerPiece;

/// As if all had the geometric mean of the least and the greatest size and covered the rectangle or box.
double expected_pieces(const CanvasSpec& canvas, const PieceSettings& pieces) {
  return double(canvas.width_px) * canvas.height_px / (double(pieces.min_scale_px) * pieces.max_scale_px);
}

/// To two significant digits: more would say that somebody knows them.
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

void set_improving_by_quality(Job& job) {
  if (job.quality == QualityWord::none) return;
  job.settings.improve.trials = trials(job.quality, expected_pieces(job.canvas, job.settings.pieces));
  job.settings.improve.seconds = 0;
}

}  // namespace tessera
