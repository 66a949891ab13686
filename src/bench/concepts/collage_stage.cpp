#include "bench/concepts/collage_stage.h"

#include <algorithm>
#include <utility>

#include "bench/inputs/library_matcher.h"
#include "core/geometry/contour.h"

namespace tessera::bench::concepts {
namespace {

constexpr int kStageWidth_px = 640, kStageHeight_px = 420;

CollageSettings figure_settings(std::array<float, 2> scale_px) {
  CollageSettings settings;
  settings.seed = 5;
  settings.pieces.min_scale_px = scale_px[0];
  settings.pieces.max_scale_px = scale_px[1];
  return settings;
}

}  // namespace

CollageStage::CollageStage(const LibraryFile& library, const std::string& devices_use, std::array<float, 2> scale_px)
    : library_(library),
      canvas_(make_rectangle_canvas(kStageWidth_px, kStageHeight_px)),
      settings_(figure_settings(scale_px)),
      shapes_(library),
      context_(make_matching_context(settings_, std::uint32_t(library.size()))),
      matcher_(std::make_unique<WeighedMatcher>(library_matcher(library, library.size(), settings_, devices_use))),
      collage_(canvas_, settings_, context_, shapes_),
      filling_(collage_, context_, settings_, *matcher_, statistics_) {
  collage_.begin({}, 0, 0);
}

Shape CollageStage::with_levels(ShapeId id) const {
  return std::move(library_.read(index_of(id), index_of(id) + 1, {.artwork = false, .original = false}).front());
}

void CollageStage::place(std::size_t pieces) {
  while (collage_.placements().size() < pieces && filling_.place_one()) {
  }
  filling_.end_batch();
}

Vec2 CollageStage::middle_of_view(Vec2 centre, float view_px) const {
  const auto within = [&](float at, int size_px) {
    const float half = 0.5f * view_px - 4;
    return float(size_px) < 2 * half ? 0.5f * float(size_px) : std::clamp(at, half, float(size_px) - half);
  };
  return {within(centre.x, canvas_.width_px), within(centre.y, canvas_.height_px)};
}

void CollageStage::draw(FigureSheet& sheet, const Similarity& sheet_from_canvas,
                        const std::vector<Placement>& placements) {
  const Vec2 far{float(canvas_.width_px), float(canvas_.height_px)};
  sheet.box({sheet_from_canvas.apply({0, 0}), sheet_from_canvas.apply(far)}, {.stroke = kInk, .width_px = 1.5});
  for (const Placement& p : placements) {
    draw_piece(sheet, sheet_from_canvas, p.shape, p.canvas_from_shape,
               {.stroke = kPaleInk, .width_px = 0.7, .fill = kPiece});
  }
}

void CollageStage::draw_piece(FigureSheet& sheet, const Similarity& sheet_from_canvas, ShapeId shape,
                              const Similarity& canvas_from_shape, const Pen& pen) {
  sheet.outline(shapes_.shape(shape).outline, followed_by(sheet_from_canvas, canvas_from_shape), pen);
}

void CollageStage::draw_roughly(FigureSheet& sheet, const Similarity& sheet_from_canvas, ShapeId shape,
                                const Similarity& canvas_from_shape, const Pen& pen) {
  constexpr std::size_t kStride = 20;
  std::vector<Vec2> some;
  const std::vector<Vec2>& outer = shapes_.shape(shape).outline.curves.front();
  for (std::size_t i = 0; i < outer.size(); i += kStride) some.push_back(outer[i]);
  sheet.closed(applied(followed_by(sheet_from_canvas, canvas_from_shape), some), pen);
}

TracedTarget::TracedTarget(const FreeField& free, const CollageSettings& settings)
    : opened(free, settings.pieces),
      curve(settings.pieces, settings.match.pad) {
  update(free, free.field().value.bounds());
}

TargetCurve::Change TracedTarget::update(const FreeField& free, const Window& changed) {
  return curve.retrace(opened, free.field().origin, opened.update(free, {changed}));
}

std::vector<TargetSample> TracedTarget::samples() const {
  std::vector<TargetSample> all;
  for (const SampleId id : curve.samples()) all.push_back(curve.sample(id));
  return all;
}

std::vector<std::vector<Vec2>> TracedTarget::contours(const FreeField& free) const {
  constexpr float kNearZero_px = 0.01f;  // a contour's level is above zero
  std::vector<std::vector<Vec2>> curves = tessera::contours(opened.contour(), kNearZero_px);
  for (std::vector<Vec2>& curve : curves) {
    for (Vec2& p : curve) p = p + free.field().origin;
  }
  return curves;
}

}  // namespace tessera::bench::concepts
