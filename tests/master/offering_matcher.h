// A matcher that offers the test's candidates, for tests of the master.
#pragma once

#include <deque>
#include <optional>

#include "core/collage/placement.h"
#include "core/geometry/polygon.h"
#include "core/matching/matcher.h"
#include "support/idle_matcher.h"
#include "support/synthetic_library.h"

namespace tessera::test {

using Offers = std::deque<std::optional<Placement>>;

inline Placement piece(std::uint32_t shape, float scale_px, Vec2 centre) {
  return {ShapeId{shape}, Similarity{scale_px, 0, centre.x, centre.y}, 1, 1};
}

/// The centre at which the shape's two nearest edges touch the upper left (or lower right) corner of the canvas. A piece that touches
/// nothing has no score.
inline Vec2 centre_at_upper_left(const Shape& shape, float scale_px) {
  constexpr float kApart_px = 0.5f;
  return bounding_box(shape.outline.curves.front()).low * (-scale_px) + Vec2{kApart_px, kApart_px};
}
inline Vec2 centre_at_lower_right(const Shape& shape, float scale_px, Vec2 canvas_px) {
  constexpr float kApart_px = 0.5f;
  return canvas_px - bounding_box(shape.outline.curves.front()).high * scale_px - Vec2{kApart_px, kApart_px};
}

/// Answers each question for dockings with the next of `offers`, whatever the field is; an empty offer means no dockings.
/// Pooled candidates that a placed piece touches are given up.
class OfferingMatcher : public Matcher {
 public:
  explicit OfferingMatcher(const std::vector<Shape>& library) : library_(library) {}

  Offers offers;
  int questions = 0;                       // the number of questions for dockings
  std::vector<std::size_t> samples_asked;  // of each

  ShapeRange shapes() const override { return {0, std::uint32_t(library_.size())}; }
  void start_field(int, int, Vec2) override {}
  void update_field(const std::vector<FieldPatch>&) override {}
  void limit(const StanceLimits&) override {}
  void post_count(const CountRequest& request) override { samples_ = test::samples_asked(request); }
  std::vector<DistanceHistogram> take_count() override { return std::vector<DistanceHistogram>(samples_); }
  void post_dock(const DockRequest& request) override {
    ++questions;
    samples_asked.push_back(request.samples.size());
  }
  DockReply take_dock() override {
    if (offers.empty()) return {};
    const std::optional<Placement> offer = offers.front();
    offers.pop_front();
    if (!offer) return {};
    Docking docking;
    docking.shape = offer->shape;
    docking.canvas_from_shape = offer->canvas_from_shape;
    return {{docking}, 1};
  }
  void post_refine(const std::vector<Docking>& dockings) override { dockings_ = dockings; }
  std::vector<RefinedDocking> take_refine() override {
    std::vector<RefinedDocking> refined;
    for (const Docking& docking : dockings_) {
      const Shape& shape = library_[index_of(docking.shape)];
      DockingTerms touching;
      touching.matched_px = shape.perimeter * docking.canvas_from_shape.scale();
      refined.push_back({docking, touching, true, Extent{0, 0, 200, 200}, shape.perimeter, shape.radius});
    }
    return refined;
  }
  void post_measure(const std::vector<Docking>& dockings) override { dockings_ = dockings; }
  std::vector<DockingTerms> take_measure() override {
    DockingTerms covered;
    covered.overlap_px2 = 1e9f;
    return std::vector<DockingTerms>(dockings_.size(), covered);
  }

 private:
  const std::vector<Shape>& library_;
  std::size_t samples_ = 0;
  std::vector<Docking> dockings_;
};

}  // namespace tessera::test
