#include "products/nesting/nest_job.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "core/base/count_text.h"
#include "job/toml_string.h"
#include "products/nesting/nest_sheets.h"
#include "products/puzzle/puzzle_geojson.h"
#include "text/number_text.h"

namespace tessera {
namespace {

namespace fs = std::filesystem;

/// The canvas of a sheet, px. Its size is chosen so that the shorter side has nearly a whole number of px and all pieces
/// fit.
struct CanvasPx {
  int width = 0;
  int height = 0;
  double per_mm = 0;
};

CanvasPx canvas_of(const NestSheet& sheet) {
  constexpr int kSide_px = 2000, kMostSide_px = 20'000;  // of the longer side
  constexpr double kLeast_px = 16;                       // the least side of a canvas
  constexpr double kWhole_px = 1e-6;
  const double longer_mm = std::max(sheet.width_mm, sheet.height_mm);
  const double ratio = std::min(sheet.width_mm, sheet.height_mm) / longer_mm;
  const auto shorter_px = [&](int longer_px) { return int(std::ceil(ratio * longer_px - kWhole_px)); };
  const auto too_much_px = [&](int longer_px) { return shorter_px(longer_px) - ratio * longer_px; };
  const int most_px = std::clamp(int(std::min(kLeast_px / ratio, 1e6)), kSide_px, kMostSide_px);
  int best_px = most_px;
  for (int px = most_px; px > most_px * 4 / 5 && ratio * px >= kLeast_px; --px) {
    if (too_much_px(px) < too_much_px(best_px) - kWhole_px) best_px = px;
  }
  const int least_px = std::max(int(kLeast_px), shorter_px(best_px));
  const bool wide = sheet.width_mm >= sheet.height_mm;
  return {wide ? best_px : least_px, wide ? least_px : best_px, best_px / longer_mm};
}

Vec2 in_px(NestPoint p, double px_per_mm) { return {float(p.x * px_per_mm), float(p.y * px_per_mm)}; }

LaidPuzzlePiece laid(const NestRun& run, const NestedPiece& piece, double px_per_mm) {
  const NestSource& source = run.input.sources[std::size_t(piece.item)];
  const NestTurn turn = turn_of(run.problem.items[std::size_t(piece.item)].angles_deg[std::size_t(piece.angle)]);
  const double scale = source.mm_per_shape * px_per_mm;
  const Vec2 at = in_px(piece.shift, px_per_mm);
  LaidPuzzlePiece out{source.drawing.name, {float(turn.cosine * scale), float(turn.sine * scale), at.x, at.y}, {}};
  for (const NestPoint p : source.drawing.outline) out.outline_px.push_back(in_px(placed(turn, piece, p), px_per_mm));
  return out;
}

}  // namespace

NestJob nest_job(const NestRun& run, int sheet, const std::string& folder, const std::string& pieces_name) {
  const NestSheet size = nest_sheet(run, sheet);
  const CanvasPx canvas = canvas_of(size);
  std::vector<LaidPuzzlePiece> pieces;
  for (const NestedPiece& piece : run.layout.pieces) {
    if (piece.sheet == sheet) pieces.push_back(laid(run, piece, canvas.per_mm));
  }
  const fs::path from = fs::absolute(folder).lexically_normal();
  const std::string library = fs::absolute(run.input.library).lexically_normal().lexically_relative(from).string();
  const std::string size_px = std::to_string(canvas.width) + ", " + std::to_string(canvas.height);
  const std::string size_mm = fixed(size.width_mm, 3) + ", " + fixed(size.height_mm, 3);
  const std::string toml = "# Nested by tessera nest: " + count_text(pieces.size(), "piece") + ", " +
                           fixed(size.width_mm, 1) + " x " + fixed(size.height_mm, 1) +
                           " mm.\n"
                           "# Every key of a job: docs/job-format.md\n\n"
                           "[library]\nfile = " +
                           toml_string(library) + "\n\n[canvas]\nsize_mm = [" + size_mm + "]\nsize_px = [" + size_px +
                           "]\n\n[start]\n# The poses of the pieces.\npieces = " + toml_string(pieces_name) +
                           "\n\n[stop]\n# No other pieces.\npieces = " + std::to_string(pieces.size()) +
                           "\n\n[improve]\ntrials = 0\n\n[output]\ndpi = " +
                           fixed(std::clamp(std::round(canvas.per_mm * 25.4), 1.0, 4800.0), 0) + "\n";
  return {toml, puzzle_geojson(pieces)};
}

}  // namespace tessera
