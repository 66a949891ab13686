#include "run/checked_job.h"

#include <algorithm>
#include <map>
#include <utility>
#include <vector>

#include "core/collage/former_pieces.h"
#include "core/collage/region_below.h"
#include "core/field/room.h"
#include "core/matching/sized_settings.h"
#include "job/canvas/canvas_file.h"
#include "job/canvas/overlays.h"
#include "job/picture_size.h"
#include "job/pieces/job_library.h"
#include "render/canvas_drawing.h"

namespace tessera {

namespace {

std::map<ShapeId, Outline> outlines_of(const std::vector<GivenPiece>& pieces, const ShapeLibrary& library) {
  constexpr LibraryParts kOutlines{.outline = true, .field = false, .levels = 0, .artwork = false};
  std::map<ShapeId, Outline> outlines;
  for (const GivenPiece& piece : pieces) {
    const auto [at, is_new] = outlines.try_emplace(piece.shape);
    const std::uint32_t i = index_of(piece.shape);
    if (is_new) at->second = std::move(library.read(i, i + 1, kOutlines).front().outline);
  }
  return outlines;
}

}  // namespace

void keep_removed_from_coming_back(const ShapeLibrary& library, const Canvas& canvas, Job& job) {
  const std::vector<GivenPiece>& removed = job.start.removed;
  if (removed.empty()) return;
  const std::map<ShapeId, Outline> outlines = outlines_of(removed, library);
  std::vector<TakenOut> pieces;
  for (const GivenPiece& piece : removed) {
    const bool one_region = canvas.regions.size() < 2;
    const Outline& outline = outlines.at(piece.shape);
    pieces.push_back({piece.shape, one_region ? 0 : region_below(canvas, outline, piece.canvas_from_shape)});
  }
  const std::vector<bool> others = others_may_come_in(pieces, job.settings, library.variant_of(), library.drawings());
  for (std::size_t i = 0; i < removed.size(); ++i) {
    if (others[i]) job.settings.wishes.not_back.push_back({removed[i].shape, removed[i].canvas_from_shape});
  }
}

double limit_to_room(const ShapeLibrary& library, const Job& job, Canvas& canvas) {
  if (job.start.removed.empty()) return 1;
  const std::map<ShapeId, Outline> outlines = outlines_of(job.start.removed, library);
  std::vector<PieceThatLay> lay;
  for (const GivenPiece& piece : job.start.removed) {
    lay.push_back({&outlines.at(piece.shape), piece.canvas_from_shape});
  }
  fill_only_where_they_lay(lay, job.settings.pieces.min_scale_px, canvas);
  double area_px2 = 0;
  for (const CanvasRegion& region : canvas.regions) area_px2 += region.area_px2;
  return std::min(1., area_px2 / canvas.area_px2);
}

LibraryView checked_library(Job& job) {
  LibraryView library = open_library_of(job);
  resolve_wishes(library, job);
  add_start_pieces(library, job);
  return library;
}

Canvas checked_canvas(const ShapeLibrary& library, Job& job) {
  Canvas canvas = canvas_of(job);
  Job drawn = job;
  drawn.output = on_paper(job.output, job.canvas, canvas);
  check_picture_size(drawn.output, canvas);
  check_canvas_drawing(drawn, canvas);
  if (job.settings.pieces.fit_all) {
    job.size_factor =
        first_size_factor(job.settings, std::uint32_t(library.size()), canvas.area_px2, library.drawings());
  }
  set_overlays(read_overlays(canvas, job), library, job);
  check_images(canvas, with_sizes_times(job.size_factor, job.settings).pieces);
  return canvas;
}

}  // namespace tessera
