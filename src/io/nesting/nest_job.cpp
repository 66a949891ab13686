#include "io/nesting/nest_job.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "io/job/toml_text.h"
#include "io/nesting/nest_sheets.h"
#include "io/number_text.h"
#include "io/puzzle/puzzle_geojson.h"

namespace tessera::io {
namespace {

namespace fs = std::filesystem;

constexpr double kCanvasSide_px = 2000;

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
  const double px_per_mm = kCanvasSide_px / std::max(size.width_mm, size.height_mm);
  std::vector<LaidPuzzlePiece> pieces;
  for (const NestedPiece& piece : run.layout.pieces) {
    if (piece.sheet == sheet) pieces.push_back(laid(run, piece, px_per_mm));
  }
  const fs::path from = fs::absolute(folder).lexically_normal();
  const std::string library = fs::absolute(run.input.library).lexically_normal().lexically_relative(from).string();
  const auto side = [&](double mm) { return std::to_string(std::max(16, int(std::ceil(mm * px_per_mm)))); };
  const std::string toml = "# Nested by tessera nest: " + std::to_string(pieces.size()) + " pieces, " +
                           fixed(size.width_mm, 1) + " x " + fixed(size.height_mm, 1) +
                           " mm.\n"
                           "# Every key of a job: docs/job-format.md\n\n"
                           "[library]\nfile = " +
                           toml_text(library) + "\n\n[canvas]\nsize_px = [" + side(size.width_mm) + ", " +
                           side(size.height_mm) +
                           "]\n\n[start]\n# Where they lie.\npieces = " + toml_text(pieces_name) +
                           "\n\n[stop]\n# No others.\npieces = " + std::to_string(pieces.size()) +
                           "\n\n[improve]\ntrials = 0\n\n[output]\nwidth_mm = " + fixed(size.width_mm, 3) +
                           "\ndpi = " + fixed(std::clamp(std::round(px_per_mm * 25.4), 1.0, 4800.0), 0) + "\n";
  return {toml, puzzle_geojson(pieces)};
}

}  // namespace tessera::io
