#include "run/collage_problem.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include "checkpoint/checkpoint_origin.h"
#include "core/base/error.h"
#include "core/collage/former_pieces.h"
#include "core/collage/region_below.h"
#include "core/field/room.h"
#include "core/matching/sized_settings.h"
#include "job/canvas/canvas_file.h"
#include "job/palette.h"
#include "job/picture_size.h"
#include "job/pieces/job_library.h"
#include "job/pieces/size_factor.h"
#include "job/quality_word.h"
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

/// Keeps the pieces of start.remove from coming back to where they lay, unless nothing else may come in for them. The whole
/// canvas counts here.
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
  const std::vector<bool> others = may_be_replaced(pieces, job.settings, library.variant_of(), library.drawings());
  for (std::size_t i = 0; i < removed.size(); ++i) {
    if (others[i]) job.settings.wishes.not_back.push_back({removed[i].shape, removed[i].canvas_from_shape});
  }
}

/// The piece settings with the sizes of the first attempt.
PieceSettings sized_pieces(const Job& job, double size_factor) {
  return with_sizes_times(size_factor, job.settings).pieces;
}

/// Limits the canvas to the room of the removed pieces, if there are any. Returns the part of the canvas that is left.
double limit_to_room(const ShapeLibrary& library, const Job& job, double size_factor, Canvas& canvas) {
  if (job.start.removed.empty()) return 1;
  const std::map<ShapeId, Outline> outlines = outlines_of(job.start.removed, library);
  std::vector<RemovedPiece> lay;
  for (const GivenPiece& piece : job.start.removed) {
    lay.push_back({&outlines.at(piece.shape), piece.canvas_from_shape});
  }
  limit_regions_to_room(lay, sized_pieces(job, size_factor).min_scale_px, canvas);
  double area_px2 = 0;
  for (const CanvasRegion& region : canvas.regions) area_px2 += region.area_px2;
  return std::min(1., area_px2 / canvas.area_px2);
}

OutputSpec checked_output(const Job& job, const Canvas& canvas) {
  OutputSpec output = on_paper(job.output, job.canvas, canvas);
  check_picture_size(output, canvas);
  try {
    check_canvas_drawing(job.canvas, output, canvas);
  } catch (const InputError& error) {
    throw InputError(job.path + ": " + error.what());
  }
  return output;
}

CanvasFindings findings_on(const Canvas& canvas, const ShapeLibrary& library, const Job& job) {
  CanvasFindings found;
  found.size_factor = size_factor_on(canvas, library, job.settings);
  const PieceSettings pieces = sized_pieces(job, found.size_factor);
  found.overlays = read_overlays(canvas, job, pieces.min_scale_px);
  check_images(canvas, pieces);
  return found;
}

CollageSettings settings_of(const Job& job, const CanvasFindings& found) {
  CollageSettings settings = with_sizes_times(found.size_factor, job.settings);
  settings.improve.trials = int(std::ceil(double(settings.improve.trials) * found.room_part));
  settings.improve.seconds *= found.room_part;
  return settings;
}

/// Finds out before the run, rather than after it, that no piece knows the photo round it.
void check_photo_background(const Job& job, const ShapeLibrary& library) {
  if (job.output.background != kPhotoBackground || library.has_surroundings()) return;
  throw InputError(job.path + ": output.background: found \"" + kPhotoBackground + "\", but no drawing in " +
                   library.path() +
                   " knows the photo that it was cut out of; needed: a library of tessera texture or " +
                   "tessera library extract, made by this version or a later one");
}

LibraryView library_of(Job& job) {
  LibraryView library = open_library_of(job);
  check_photo_background(job, library);
  resolve_wishes(library, job);
  add_start_pieces(library, job);
  return library;
}

}  // namespace

CollageProblem::CollageProblem(Job job, LibraryView library, CanvasFindings found)
    : job_(std::move(job)),
      library_(std::move(library)),
      found_(std::move(found)) {
  set_overlays(found_.overlays, library_, job_);
  settings_ = settings_of(job_, found_);
}

/// The inputs that the constructor reads. Each member depends on the members before it.
struct CanvasProblem::Read {
  explicit Read(Job raw)
      : job(std::move(raw)),
        library(library_of(job)),
        palette(load_palette(job)),
        canvas(canvas_of(job)),
        output(checked_output(job, canvas)),
        found(findings_on(canvas, library, job)),
        digest(tessera::canvas_digest(canvas)) {
    set_improving_by_quality(job, found.size_factor);
    keep_removed_from_coming_back(library, canvas, job);
    found.room_part = limit_to_room(library, job, found.size_factor, canvas);
  }

  Job job;
  LibraryView library;
  std::vector<std::string> palette;
  Canvas canvas;
  OutputSpec output;
  CanvasFindings found;
  std::uint64_t digest;
};

CanvasProblem::CanvasProblem(Job raw) : CanvasProblem(Read(std::move(raw))) {}

CanvasProblem::CanvasProblem(Read read)
    : CollageProblem(std::move(read.job), std::move(read.library), std::move(read.found)),
      canvas_(std::move(read.canvas)),
      canvas_digest_(read.digest),
      output_(std::move(read.output)),
      palette_(std::move(read.palette)) {}

}  // namespace tessera
