#include "master/choosing/settling.h"

#include "core/field/line_art.h"
#include "core/matching/refinement.h"
#include "core/settings/tuning.h"
#include "core/shape/shape_field.h"

namespace tessera::master {
namespace {

constexpr float kLookUp_px = 2;  // a look-up reads the nodes round its point

}  // namespace

/// One shape on its way from a pose to one where it may stand.
class Settling::Attempt {
 public:
  Attempt(const Settling& settling, const Shape& shape, const ShapeModel& model, const PoseRange& poses,
          const Similarity& canvas_from_shape)
      : free_(settling.free_),
        outlines_(settling.outlines_),
        shape_(shape),
        model_(model),
        poses_(poses),
        most_px_(most_depth_px(settling.context_.hard_depth_px,
                               line_radius(shape.field, shape.perimeter) * canvas_from_shape.scale())),
        pose_(canvas_from_shape) {}

  SettledPose settle() {
    const bool fits = push_clear() && grow_and_fit();
    return {fits, pose_, read_};
  }

 private:
  bool grow_and_fit() {
    grow();
    return fit_exactly();
  }

  /// Pushes the pose by the free field, as refinement does.
  bool push_clear() {
    note_read(longest_way_px(kSettle, least_radius_px()));
    for (int step = 0; depth() > most_px_; ++step) {
      if (step == kSettleSteps) return false;
      descend(pose_, model_, free_.view(), kSettle, poses_);
      note_read(longest_way_px(kSettle, least_radius_px()));
      if (depth() <= most_px_) break;
      shrink();
      if (pose_.scale() < poses_.min_scale_px) return false;
    }
    return true;
  }

  void grow() {
    const float way_px =
        longest_way_px(kGrow, least_radius_px()) + (kGrowStep - 1) * model_.radius * poses_.max_scale_px;
    note_read(way_px);
    for (int step = 0; step < kGrowSteps && grow_step(pose_, model_, free_.view(), poses_, most_px_); ++step)
      note_read(way_px);
  }

  /// Corrects the pose by the outlines themselves, which see what fields and boundary points do not.
  bool fit_exactly() {
    for (int step = 0; step < kExactSteps; ++step) {
      note_read(0);
      const std::vector<Vec2> ways = outlines_.conflicts(shape_, pose_);
      if (ways.empty()) return true;
      for (const Vec2& way : ways) {
        pose_.tx += way.x;
        pose_.ty += way.y;
      }
      if (step == 0) continue;
      shrink();
      poses_.pull_in(pose_);
    }
    return false;
  }

  float depth() const { return depth_px(pose_, model_, free_.view()); }
  float least_radius_px() const { return model_.radius * poses_.min_scale_px; }

  void shrink() {
    pose_.a *= kSettleShrink;
    pose_.b *= kSettleShrink;
  }

  /// Notes that the nodes round the piece are read, up to `way_px` from its outline.
  void note_read(float way_px) {
    read_ = read_.united(
        piece_window(shape_.outline, pose_, free_.field().origin, way_px + free_.padding_px() + kLookUp_px));
  }

  const FreeField& free_;
  const PlacedOutlines& outlines_;
  const Shape& shape_;
  const ShapeModel& model_;
  const PoseRange& poses_;
  float most_px_;  // the depth to which boundary points may lie in other pieces
  Similarity pose_;
  Window read_;
};

SettledPose Settling::settle(const Shape& shape, const ShapeModel& model, const PoseRange& poses,
                             const Similarity& canvas_from_shape) const {
  return Attempt(*this, shape, model, poses, canvas_from_shape).settle();
}

}  // namespace tessera::master
