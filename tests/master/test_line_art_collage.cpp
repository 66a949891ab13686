// Collages of shapes that enclose much and cover little. A run ends only when no gap is wide enough for another shape, and no line crosses
// another.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/base/stop.h"
#include "core/collage/placed_outlines.h"
#include "core/collage/wide_gap.h"
#include "core/shape/shape_field.h"
#include "stopped_collage.h"
#include "whole_collage.h"

namespace tessera::master {
namespace test_line_art_collage {

const std::vector<Shape>& line_art() {
  static const std::vector<Shape> shapes = {test::make_library_shape("spectacles", test::spectacles_outline(0.2f)),
                                            test::make_library_shape("ring", test::ring_outline(0.85f))};
  return shapes;
}

CollageSettings line_art_settings() {
  CollageSettings s;
  s.pieces.min_scale_px = 20;
  s.pieces.max_scale_px = 60;
  return s;
}

Canvas line_art_canvas() { return make_rectangle_canvas(240, 180); }

CollageResult run_line_art(const CollageSettings& s, const std::vector<Shape>& library) {
  SilentObserver silent;
  return stopped_collage::run(s, {}, silent, {}, line_art_canvas(), library);
}

/// Counts the poses of the smallest size that fit with half a px to spare all round. It tries every 2 px and every eighth of a quarter
/// turn.
int poses_that_fit(const CollageResult& result, const CollageSettings& s, const std::vector<Shape>& library) {
  constexpr int kTurns = 32;
  FreeField free(line_art_canvas(), s.pieces);
  for (const Placement& p : result.placements) free.stamp(library[index_of(p.shape)], p.canvas_from_shape);
  const auto fits = [&](const ShapeModel& shape, const Similarity& pose) {
    const auto is_clear = [&](Vec2 p) { return field_value(free.view(), pose.apply(p)) > 0.5f; };
    return std::all_of(shape.boundary.begin(), shape.boundary.end(), is_clear) &&
           std::all_of(shape.interior.begin(), shape.interior.end(), is_clear);
  };
  int found = 0;
  for (const Shape& shape : library) {
    const ShapeModel model = make_shape_model(shape, PadParameters{}, PadParameters{}, {});
    for (int turn = 0; turn < kTurns; ++turn) {
      const float angle = test::kTwoPi * float(turn) / kTurns;
      const Vec2 along = Vec2{std::cos(angle), std::sin(angle)} * s.pieces.min_scale_px;
      for (int y = 0; y < 180; y += 2) {
        for (int x = 0; x < 240; x += 2) found += fits(model, {along.x, along.y, float(x), float(y)});
      }
    }
  }
  return found;
}

/// Counts the vertices that lie so deep in another piece that lines cross.
int crossings(const std::vector<Placement>& placements, const std::vector<Shape>& library) {
  int found = 0;
  for (const Placement& inner : placements) {
    for (const Placement& outer : placements) {
      if (&inner == &outer) continue;
      const Shape& shape = library[index_of(outer.shape)];
      const float scale_px = outer.canvas_from_shape.scale();
      const float most_px = 0.9f * line_radius(shape.field, shape.perimeter) * scale_px;
      const Similarity to_outer = outer.canvas_from_shape.inverse();
      const Outline outline = placed_outline(library[index_of(inner.shape)].outline, inner.canvas_from_shape);
      for (const std::vector<Vec2>& curve : outline.curves) {
        found += int(std::count_if(curve.begin(), curve.end(),
                                   [&](Vec2 p) { return shape.field.at(to_outer.apply(p)) * scale_px < -most_px; }));
      }
    }
  }
  return found;
}

TEST(LineArtCollage, FillsTheCanvas) {
  const std::vector<Shape> spectacles = {line_art().front()};
  const CollageSettings s = line_art_settings();
  const CollageResult result = run_line_art(s, spectacles);
  EXPECT_EQ(result.statistics.stopped_by, StopReason::full);
  EXPECT_GT(whole_collage::quality_of(line_art_canvas(), result.placements, spectacles).coverage, 0.2);
  EXPECT_EQ(poses_that_fit(result, s, spectacles), 0);
  EXPECT_EQ(crossings(result.placements, spectacles), 0);
}

TEST(LineArtCollage, FillsLinesWithLines) {
  const CollageSettings s = line_art_settings();
  const CollageResult result = run_line_art(s, line_art());
  EXPECT_GT(whole_collage::quality_of(line_art_canvas(), result.placements, line_art()).coverage, 0.4);
  EXPECT_EQ(poses_that_fit(result, s, line_art()), 0);
  EXPECT_EQ(crossings(result.placements, line_art()), 0);
}

TEST(LineArtCollage, ImprovesWithoutCrossings) {
  CollageSettings s = line_art_settings();
  s.improve.trials = 3;
  const CollageResult result = run_line_art(s, line_art());
  EXPECT_EQ(result.statistics.trials, 3u);
  EXPECT_EQ(crossings(result.placements, line_art()), 0);
}

/// A disc with twelve rays, each a fortieth of the disc wide.
Outline sun_outline() {
  constexpr float kRay = 0.025f;  // half its width; the disc's radius is 1
  std::vector<Vec2> edge;
  const auto add = [&](float radius, float angle) {
    edge.push_back({radius * std::cos(angle), radius * std::sin(angle)});
  };
  for (int ray = 0; ray < 12; ++ray) {
    const float middle = test::kTwoPi * float(ray) / 12;
    for (const auto& [radius, side] : {std::pair(1.f, -1.f), {2.2f, -1.f}, {2.2f, 1.f}, {1.f, 1.f}})
      add(radius, middle + side * kRay / radius);
    for (int k = 1; k < 8; ++k) add(1, middle + test::kTwoPi * float(k) / 96);
  }
  return {{test::resampled(edge, test::kOuterPoints)}};
}

/// The tips of the rays are so small a part of the boundary that no docking counts as touching.
TEST(LineArtCollage, ASunWithThinRaysFindsAPlaceOnAnEmptyCanvas) {
  const std::vector<Shape> sun = {test::make_library_shape("sun", sun_outline())};
  CollageSettings s = line_art_settings();
  s.pieces.min_scale_px = 60;
  s.pieces.max_scale_px = 70;
  SilentObserver silent;
  const CollageResult result = stopped_collage::run(s, {}, silent, {}, make_rectangle_canvas(320, 320), sun);
  EXPECT_GE(result.placements.size(), 4u);
  EXPECT_EQ(crossings(result.placements, sun), 0);
}

/// Sticks enclose nothing, but a docking with a small error turns their far end into other pieces.
TEST(LineArtCollage, LongSticksLeaveNoWideGap) {
  const std::vector<Shape> sticks = {test::make_library_shape("stick", test::rectangle_outline(40, 1)),
                                     test::make_library_shape("shorter", test::rectangle_outline(36, 1))};
  CollageSettings s = line_art_settings();
  s.pieces.min_scale_px = 10;
  s.pieces.max_scale_px = 16;
  const CollageResult result = run_line_art(s, sticks);
  FreeField free(line_art_canvas(), s.pieces);
  for (const Placement& p : result.placements) free.stamp(sticks[index_of(p.shape)], p.canvas_from_shape);
  EXPECT_LT(widest_gap_px(free, free.field().value.bounds()), 20);
  EXPECT_GT(whole_collage::quality_of(line_art_canvas(), result.placements, sticks).coverage, 0.5);
}

/// Neither the box of a shape nor the area inside its lines counts.
TEST(LineArtCollage, CountsWhatIsPaintedAlone) {
  CollageSettings s = line_art_settings();
  double covered = 0;
  class Latest : public Observer {
   public:
    explicit Latest(double& covered) : covered_(covered) {}
    void progressed(const Progress& progress) override { covered_ = progress.coverage; }
    std::optional<StopReason> stop_requested() override { return std::nullopt; }

   private:
    double& covered_;
  } latest(covered);
  s.stop.pieces = 5;
  const CollageResult result = stopped_collage::run(s, {}, latest, {}, line_art_canvas(), line_art());
  double painted_px2 = 0;
  for (const Placement& p : result.placements) {
    const Outline outline = placed_outline(line_art()[index_of(p.shape)].outline, p.canvas_from_shape);
    painted_px2 += area_moment(outline).area;
  }
  EXPECT_NEAR(covered, painted_px2 / (240 * 180), 2e-3) << "the outlines are polygons";
  EXPECT_NEAR(whole_collage::quality_of(line_art_canvas(), result.placements, line_art()).coverage, covered, 2e-3);
}

/// This also holds in the passes that look for wide gaps.
TEST(LineArtCollage, IsTheSameOnAnyDivisionAndAfterInterruptions) {
  CollageSettings s = line_art_settings();
  s.match.tangent_dockings = 150;
  const Canvas canvas = make_rectangle_canvas(150, 110);
  SilentObserver silent;
  const CollageResult whole = stopped_collage::run(s, {}, silent, {}, canvas, line_art());
  EXPECT_EQ(stopped_collage::run(s, {1}, silent, {}, canvas, line_art()).placements, whole.placements);
  stopped_collage::KeepLatest keeper;
  Checkpoints checkpoints{nullptr, &keeper};
  CheckpointState from;
  CollageResult result;
  do {
    stopped_collage::StopAfter observer(2);
    result = stopped_collage::run(s, {1}, observer, checkpoints, canvas, line_art());
    from = keeper.latest;
    checkpoints.from = &from;
  } while (result.unfinished);
  EXPECT_EQ(result.placements, whole.placements);
}

}  // namespace test_line_art_collage
}  // namespace tessera::master
