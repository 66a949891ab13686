#include "master/settling.h"

#include "core/field/line_art.h"
#include "core/matching/refinement.h"
#include "core/settings/tuning.h"
#include "core/shape/shape_field.h"

namespace tessera::master {
namespace {

void shrink(Similarity& pose) {
  pose.a *= kSettleShrink;
  pose.b *= kSettleShrink;
}

}  // namespace

bool Settling::settle(ShapeId shape, const PoseRange& poses, Similarity& canvas_from_shape) {
  const float most_px = hard_depth_of(shapes_.shape(shape), canvas_from_shape.scale());
  const ShapeModel& model = shapes_.model(shape);
  if (!push_clear(model, poses, most_px, canvas_from_shape)) return false;
  grow(canvas_from_shape, model, free_.view(), poses, most_px);
  return fit_exactly(shapes_.shape(shape), poses, canvas_from_shape);
}

float Settling::hard_depth_of(const Shape& shape, float scale_px) const {
  return most_depth_px(context_.hard_depth_px, line_radius(shape.field, shape.perimeter) * scale_px);
}

/// Pushes the pose by the free field, as refinement does.
bool Settling::push_clear(const ShapeModel& model, const PoseRange& poses, float most_px, Similarity& pose) const {
  const FieldView field = free_.view();
  for (int step = 0; depth_px(pose, model, field) > most_px; ++step) {
    if (step == kSettleSteps) return false;
    descend(pose, model, field, kSettle, poses);
    if (depth_px(pose, model, field) <= most_px) break;
    shrink(pose);
    if (pose.scale() < poses.min_scale_px) return false;
  }
  return true;
}

/// Corrects the pose by the outlines themselves, which see what fields and boundary points do not.
bool Settling::fit_exactly(const Shape& shape, const PoseRange& poses, Similarity& pose) const {
  for (int step = 0; step < kExactSteps; ++step) {
    const std::vector<Vec2> ways = outlines_.conflicts(shape, pose);
    if (ways.empty()) return true;
    for (const Vec2& way : ways) {
      pose.tx += way.x;
      pose.ty += way.y;
    }
    if (step == 0) continue;
    shrink(pose);
    poses.pull_in(pose);
  }
  return false;
}

}  // namespace tessera::master
