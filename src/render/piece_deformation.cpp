#include "render/piece_deformation.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include "core/base/count_text.h"
#include "core/base/error.h"
#include "core/base/rank_pool.h"
#include "core/base/stopwatch.h"
#include "core/collage/placed_outlines.h"
#include "core/deform/deformation.h"
#include "core/deform/unfolded_fit.h"
#include "core/quality/quality.h"
#include "render/pieces/artwork_clip.h"
#include "result/folder/result_file.h"
#include "result/polygon_features.h"

namespace tessera {
namespace {

/// A warp that moves nothing by more than this changes no picture.
constexpr float kSeen_px = 0.01f;
/// Part of a piece's size: points that moved farther were not moved by deforming.
constexpr float kFarthest = 1;
constexpr float kMostPage = 4;    // shape units from its middle, which makes half a million nodes
constexpr float kPageRim_px = 2;  // artwork px, for interpolation between pixels

const Shape& shape_of(const CollageReport& report, const Placement& placement) { return report.shape(placement.shape); }

/// Whether a piece is not deformed: locked pieces, pieces that keep a distance from their like, and shapes without area,
/// which only a damaged library holds.
bool stays(const CollageReport& report, const CollageSettings& settings, std::size_t piece) {
  const Wishes& wishes = settings.wishes;
  const ShapeId shape = report.placements[piece].shape;
  if (piece < wishes.locked() && wishes.given[piece].for_good) return true;
  if (settings.pieces.apart_px > 0 || !(area_moment(report.shape(shape).outline).area > 0)) return true;
  if (wishes.class_of_shape.empty()) return false;
  const ShapeWish& wish = wishes.classes[wishes.class_of_shape[index_of(shape)]];
  return !wish.deforms || (wish.apart && wish.apart->distance_px > 0);
}

std::vector<DeformablePiece> deformable(const CollageReport& report, const CollageSettings& settings) {
  std::vector<DeformablePiece> pieces;
  for (std::size_t i = 0; i < report.placements.size(); ++i) {
    const Placement& placement = report.placements[i];
    pieces.push_back({&shape_of(report, placement), placement.canvas_from_shape, stays(report, settings, i)});
  }
  return pieces;
}

float farthest(const Warp& warp) {
  float most = 0;
  for (const Vec2 d : warp.displacement.data()) most = std::max(most, norm(d));
  return most;
}

/// The shape of a deformed piece, on a page that has room for what moved beyond its edge.
Shape deformed_shape(const Shape& original, Outline outline, float margin_px) {
  Shape shape;
  shape.name = original.name;
  shape.outline = std::move(outline);
  shape.perimeter = original.perimeter;
  shape.radius = original.radius;
  shape.mean_lab = original.mean_lab;
  shape.colour_spread = original.colour_spread;
  shape.drawn_scale_px = original.drawn_scale_px;
  shape.artwork.path = original.artwork.path;
  shape.artwork.mirrored = original.artwork.mirrored;
  shape.artwork.unit_px = original.artwork.unit_px;
  shape.artwork.width_px = original.artwork.width_px + 2 * int(margin_px);
  shape.artwork.height_px = original.artwork.height_px + 2 * int(margin_px);
  shape.artwork.centroid_px = original.artwork.centroid_px + Vec2{margin_px, margin_px};
  return shape;
}

/// Spreads the warp to what is drawn beside the outline, as far as pages of usual proportions reach.
Warp spread_over_page(const Warp& warp, const Shape& shape) {
  const Box page = bounding_box(artwork_page_outline(shape));
  const auto within = [](float v) { return std::clamp(v, -kMostPage, kMostPage); };
  return spread(warp, {within(page.low.x), within(page.low.y)}, {within(page.high.x), within(page.high.y)});
}

/// Gives each piece a shape of its own.
void give_shapes(CollageReport& report, std::vector<Outline> outlines, std::vector<Warp> warps,
                 const DeformationFigures& figures) {
  DeformedCollage deformed;
  PlacedShapes shapes;
  for (std::size_t i = 0; i < report.placements.size(); ++i) {
    Placement& placement = report.placements[i];
    const Shape& original = shape_of(report, placement);
    if (report.output.clip == kNoClip) warps[i] = spread_over_page(warps[i], original);
    const float margin_px = std::ceil(farthest(warps[i]) * original.artwork.unit_px) + kPageRim_px;
    shapes.add_apart(ShapeId(i), deformed_shape(original, std::move(outlines[i]), margin_px));
    deformed.shapes.push_back(placement.shape);
    deformed.margin_px.push_back(margin_px);
  }
  for (std::size_t i = 0; i < report.placements.size(); ++i) report.placements[i].shape = ShapeId(i);
  deformed.warps = std::move(warps);
  deformed.figures = figures;
  deformed.originals = std::exchange(report.shapes, std::move(shapes));
  report.deformed = std::move(deformed);
}

double median(std::vector<double> values) {
  if (values.empty()) return 0;
  const auto middle = values.begin() + std::ptrdiff_t(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

DeformationFigures figures_of(const std::vector<DeformedPiece>& pieces) {
  DeformationFigures figures;
  std::vector<double> pads, areas;
  for (const DeformedPiece& piece : pieces) {
    if (piece.farthest_px < kSeen_px) continue;
    ++figures.pieces;
    pads.push_back(double(piece.pad_distance));
    areas.push_back(std::abs(double(piece.area_ratio) - 1));
    figures.largest_pad_distance = std::max(figures.largest_pad_distance, pads.back());
    figures.largest_area_change = std::max(figures.largest_area_change, areas.back());
    figures.farthest_px = std::max(figures.farthest_px, double(piece.farthest_px));
    figures.least_jacobian = std::min(figures.least_jacobian, double(piece.least_jacobian));
  }
  figures.median_pad_distance = median(std::move(pads));
  figures.median_area_change = median(std::move(areas));
  return figures;
}

Quality quality_before(const CollageReport& report) {
  return measure_quality(*report.canvas, report.placements,
                         [&](ShapeId id) -> const Shape& { return report.shape(id); });
}

/// Reads the outlines in pieces.geojson, canvas px.
std::vector<Outline> written_outlines(const std::string& dir) {
  JsonFile file{open_result_file(dir, "pieces.geojson", kMostPiecesBytes)};
  std::vector<Outline> outlines;
  try {
    read_polygon_features(file, [&](PolygonFeature feature) {
      Outline outline;
      for (std::vector<Ring>& polygon : feature.polygons) {
        for (Ring& ring : polygon) {
          ring.pop_back();  // equal to the first point
          outline.curves.push_back(std::move(ring));
        }
      }
      outlines.push_back(std::move(outline));
    });
  } catch (const InputError& error) {
    throw InputError(path_in_result(dir, "pieces.geojson") + ": " + error.what());
  }
  return outlines;
}

std::vector<std::size_t> points_of(const Outline& outline) {
  std::vector<std::size_t> counts;
  for (const auto& curve : outline.curves) counts.push_back(curve.size());
  return counts;
}

/// How the points of the outline moved. Throws InputError where `after` is not the outline of the same shape.
std::vector<Vec2> displacements(const Outline& before, const Outline& after) {
  if (points_of(before) != points_of(after)) throw InputError("a polygon that does not belong to its shape");
  std::vector<Vec2> moves;
  for (std::size_t c = 0; c < before.curves.size(); ++c) {
    for (std::size_t i = 0; i < before.curves[c].size(); ++i) {
      moves.push_back(after.curves[c][i] - before.curves[c][i]);
      if (!(norm(moves.back()) <= kFarthest)) throw InputError("a polygon far from the place of its shape");
    }
  }
  return moves;
}

}  // namespace

void deform_pieces(CollageReport& report, const CollageSettings& settings) {
  const Quality before = quality_before(report);
  const Stopwatch watch;
  std::vector<DeformedPiece> pieces = deformed_pieces(*report.canvas, deformable(report, settings), settings.deform,
                                                      settings.match.pad, settings.pieces.padding_px);
  DeformationFigures figures = figures_of(pieces);
  figures.seconds = watch.seconds();
  figures.coverage_before = before.coverage;
  figures.overlap_before = before.overlap;
  std::vector<Outline> outlines;
  std::vector<Warp> warps;
  for (DeformedPiece& piece : pieces) {
    outlines.push_back(std::move(piece.outline));
    warps.push_back(std::move(piece.warp));
  }
  give_shapes(report, std::move(outlines), std::move(warps), figures);
}

void restore_deformed_pieces(const std::string& dir, CollageReport& report, const StopCheck& check_stop) {
  const std::vector<Outline> written = written_outlines(dir);
  const std::size_t count = report.placements.size();
  if (written.size() != count) {
    throw InputError(path_in_result(dir, "pieces.geojson") + ": found " + count_text(written.size(), "polygon") +
                     ", allowed: one for each piece");
  }
  std::vector<Outline> outlines(count);
  std::vector<Warp> warps(count);
  parallel_for(count, [&](std::size_t i) {
    check_stop();
    const Placement& placement = report.placements[i];
    const Shape& shape = shape_of(report, placement);
    try {
      const Similarity& pose = placement.canvas_from_shape;
      outlines[i] = placed_outline(written[i], pose.inverse());
      warps[i] = UnfoldedFit(shape, pose.scale(), kMadeStiffness_px).warp(displacements(shape.outline, outlines[i]));
    } catch (const InputError& error) {
      throw InputError(path_in_result(dir, "pieces.geojson") + ": feature " + std::to_string(i) + ": found " +
                       error.what() + "; allowed: the pieces of its job, library and manifest");
    }
  });
  give_shapes(report, std::move(outlines), std::move(warps), {});
}

}  // namespace tessera
