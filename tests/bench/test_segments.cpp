// Descriptors of whole shapes, extended to segments: they find a cut again, and the benchmark compares them.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "bench/benchmarks.h"
#include "bench/blocking/silhouettes.h"
#include "bench/blocking_silhouettes.h"
#include "bench/inputs/formula_shapes.h"
#include "bench/segments/segment_matcher.h"
#include "bench/segments/timed_collage.h"
#include "core/base/error.h"
#include "support/matcher_round.h"

namespace tessera::bench {
namespace test_segments {

std::vector<std::unique_ptr<ShapeDescriptor>> segment_descriptors() {
  std::vector<std::unique_ptr<ShapeDescriptor>> all;
  all.push_back(make_shape_context(20));
  all.push_back(make_hu_moments());
  return all;
}

/// The line that cuts the disc. It bends both ways, and its halves differ.
float cut_at(float x) { return 0.3f * std::sin(2.6f * x + 0.4f) + 0.12f * std::sin(5.5f * x); }

/// The part of the unit disc on one side of the cut, with its interior on the left.
Outline half_disc(bool upper) {
  constexpr int kPoints = 600;
  std::vector<Vec2> curve;
  const auto on_cut = [](float x) { return Vec2{x, cut_at(x)}; };
  float left = -1, right = 1;  // the ends of the cut on the disc
  while (norm(on_cut(left)) > 1) left += 1e-3f;
  while (norm(on_cut(right)) > 1) right -= 1e-3f;
  const auto at = [&](int i) { return left + (right - left) * float(i) / kPoints; };
  for (int i = 0; i <= kPoints; ++i) curve.push_back(on_cut(at(upper ? i : kPoints - i)));
  const float from = std::atan2(curve.back().y, curve.back().x);
  float to = std::atan2(curve.front().y, curve.front().x);
  if (to < from) to += test::kTwoPi;
  for (int i = 1; i < kPoints; ++i) {
    const float angle = from + (to - from) * float(i) / kPoints;
    curve.push_back({std::cos(angle), std::sin(angle)});
  }
  return {{curve}};
}

/// The unit disc's radius and middle on the canvas, in px.
constexpr float kRadius_px = 90;
constexpr float kMiddle_px = 150;

/// The pose of a part that completes the disc on the canvas.
Similarity pose_in_disc(const Shape& part) {
  constexpr float kArtwork_px = 150;  // the disc's radius in the artwork, as test::shape_from_outline draws it
  const float canvas_px = kRadius_px / kArtwork_px;
  const Vec2 centre = part.artwork.centroid_px * canvas_px + Vec2{kMiddle_px, kMiddle_px};
  return {part.artwork.unit_px * canvas_px, 0, centre.x, centre.y};
}

float farthest_point_px(const Shape& shape, const Similarity& a, const Similarity& b) {
  float farthest = 0;
  for (const Vec2 p : shape.outline.curves.front()) farthest = std::max(farthest, norm(a.apply(p) - b.apply(p)));
  return farthest;
}

/// The canvas holds the lower part. The library has the upper one, turned, with other shapes before and after it.
struct CutDisc {
  static constexpr std::uint32_t kUpper = 1;

  CutDisc() : free(make_rectangle_canvas(300, 300), pieces()) {
    shapes = blob_shapes(3);
    shapes[kUpper] = test::shape_from_outline(half_disc(true), {});
    const Shape lower = test::shape_from_outline(half_disc(false), {});
    free.stamp(lower, pose_in_disc(lower));
    settings.pieces = pieces();
    context = make_matching_context(settings, std::uint32_t(shapes.size()));
    for (const TargetSample& sample : test::trace_samples(free, settings, 1000)) {
      const Vec2 at = (sample.position - Vec2{kMiddle_px, kMiddle_px}) * (1 / kRadius_px);
      if (std::abs(at.x) < 0.4f && std::abs(at.y - cut_at(at.x)) < 0.1f) on_cut.push_back(sample);
    }
  }

  static PieceSettings pieces() {
    PieceSettings pieces;
    pieces.min_scale_px = 70;
    pieces.max_scale_px = 140;
    return pieces;
  }

  SegmentMatcher matcher(std::unique_ptr<ShapeDescriptor> descriptor, std::size_t pairs, StopCheck check = never_stop) {
    SegmentMatcher made(segment_settings(settings), context, shapes, models_of(shapes, context),
                        {std::move(descriptor), pairs, std::move(check)});
    test::set_field(made, free.field());
    return made;
  }

  CollageSettings settings;
  MatchingContext context;
  std::vector<Shape> shapes;
  FreeField free;
  std::vector<TargetSample> on_cut;
};

/// The number of refined dockings that put the upper part within 1 px of its original place.
std::size_t found_again(const CutDisc& cut, SegmentMatcher& matcher, const DockReply& reply) {
  const Similarity expected = pose_in_disc(cut.shapes[CutDisc::kUpper]);
  matcher.post_refine(reply.dockings);
  std::size_t found = 0;
  for (const RefinedDocking& refined : matcher.take_refine()) {
    const Docking& docking = refined.docking;
    found += refined.feasible && docking.shape == ShapeId{CutDisc::kUpper} &&
             farthest_point_px(cut.shapes[CutDisc::kUpper], docking.canvas_from_shape, expected) < 1;
  }
  return found;
}

TEST(SegmentMatcher, TheNearestPairIsWhatWasOneCurve) {
  CutDisc cut;
  ASSERT_GE(cut.on_cut.size(), 3u);
  for (auto& descriptor : segment_descriptors()) {
    SCOPED_TRACE(descriptor->name());
    SegmentMatcher matcher = cut.matcher(std::move(descriptor), 1);
    matcher.post_dock({cut.on_cut, {}, 0});
    const DockReply reply = matcher.take_dock();
    EXPECT_GE(2 * reply.dockings.size(),
              cut.on_cut.size());  // pairs of other shapes do not align and are not docked
    EXPECT_EQ(found_again(cut, matcher, reply), reply.dockings.size());
    EXPECT_GT(matcher.compared(), 1000u);
  }
}

TEST(SegmentMatcher, DocksTheBestOfAllPairsFirst) {
  CutDisc cut;
  for (auto& descriptor : segment_descriptors()) {
    SCOPED_TRACE(descriptor->name());
    SegmentMatcher matcher = cut.matcher(std::move(descriptor), 200);
    matcher.post_dock({cut.on_cut, {}, 0});
    DockReply reply = matcher.take_dock();
    EXPECT_GE(reply.evaluated, reply.dockings.size());
    std::vector<Docking> best;
    for (const Docking& docking : reply.dockings) {
      if (best.empty() || best.back().sample != docking.sample) best.push_back(docking);
    }
    ASSERT_EQ(best.size(), cut.on_cut.size());
    EXPECT_EQ(found_again(cut, matcher, {best, 0}), best.size());
  }
}

TEST(SegmentMatcher, LeavesOutWhatMayNotStand) {
  CutDisc cut;
  SegmentMatcher matcher = cut.matcher(make_hu_moments(), 200);
  matcher.limit({.used_up = {ShapeId{CutDisc::kUpper}}});
  matcher.post_dock({cut.on_cut, {}, 0});
  for (const Docking& docking : matcher.take_dock().dockings) EXPECT_NE(docking.shape, ShapeId{CutDisc::kUpper});
  matcher.limit({.used_up = {ShapeId{0}, ShapeId{1}, ShapeId{2}}});
  const std::uint64_t before = matcher.compared();
  matcher.post_dock({cut.on_cut, {}, 0});
  EXPECT_TRUE(matcher.take_dock().dockings.empty());
  EXPECT_EQ(matcher.compared(), before);
}

TEST(SegmentMatcher, EndsWhenItIsToldTo) {
  CutDisc cut;
  SegmentMatcher matcher =
      cut.matcher(make_hu_moments(), 200, stop_check([] { return std::optional(StopReason::time_limit); }));
  EXPECT_THROW(matcher.post_dock({cut.on_cut, {}, 0}), Interrupted);
}

TEST(SegmentMatcher, CountsNoPads) {
  CutDisc cut;
  SegmentMatcher matcher = cut.matcher(make_hu_moments(), 200);
  EXPECT_THROW(matcher.post_count(test::count_all(cut.on_cut)), std::logic_error);
}

TEST(TargetStretches, RunFromEndToEndOfALevel) {
  const CutDisc cut;
  TargetStretches stretches(cut.settings.pieces);
  stretches.trace(cut.free.field());
  const int levels = cut.settings.match.pad.levels;
  for (const TargetSample& sample : cut.on_cut) {
    for (int level = 0; level < levels - 1; ++level) {
      const std::vector<Vec2> stretch = stretches.around(sample, level);
      ASSERT_GE(stretch.size(), 1u);
      constexpr float kEdge_px = 1.5f;  // the longest edge of the traced curve
      EXPECT_LT(norm(stretch.front() - sample.pyramid.keypoint[std::size_t(levels - 1 - level)]), kEdge_px);
      EXPECT_LT(norm(stretch.back() - sample.pyramid.keypoint[std::size_t(levels + 1 + level)]), kEdge_px);
    }
  }
}

TEST(TargetStretches, AreNoneWhereTheyWouldBeTheWholeCurve) {
  const CutDisc cut;
  TargetStretches stretches(cut.settings.pieces);
  stretches.trace(cut.free.field());
  TargetSample sample = cut.on_cut.front();
  sample.pyramid.left[0] = sample.pyramid.right[0] = 1e5f;
  EXPECT_TRUE(stretches.around(sample, 0).empty());
  sample.pyramid.right[0] = 5;
  EXPECT_TRUE(stretches.around(sample, 0).empty());
  sample.id = SampleId{0};
  EXPECT_TRUE(stretches.around(sample, 1).empty()) << "not on the curve";
}

TEST(ShapeSegments, HaveEachLengthFromEachStart) {
  const Shape disc = test::shape_from_outline(test::disc_outline(), {});
  const std::vector<LevelSegments> levels = make_shape_segments(disc, {1, 4}, *make_hu_moments());
  ASSERT_EQ(levels.size(), 2u);
  EXPECT_EQ(levels[0].starts, 64u);
  EXPECT_EQ(levels[1].starts, 128u);
  for (std::size_t k = 0; k < 2; ++k) {
    EXPECT_EQ(levels[k].segments.size(), levels[k].starts * kSegmentLengths);
    const float perimeter = disc.levels[k == 0 ? 1 : 4].perimeter;
    for (int length = 0; length < kSegmentLengths; ++length) {
      EXPECT_NEAR(levels[k].at(length, 0).length, segment_part(length) * perimeter, 0.003f * perimeter);
      EXPECT_TRUE(levels[k].at(length, 5).bulges);
    }
  }
}

/// A bulge and the same curve as a dent have one description; only `bulges` tells them apart.
TEST(CurveSegment, IsDescribedWithItsAreaOnTheLeft) {
  std::vector<Vec2> arc;
  for (int i = 0; i <= 60; ++i) arc.push_back({std::cos(0.04f * float(i)), std::sin(0.04f * float(i))});
  for (const auto& descriptor : segment_descriptors()) {
    const CurveSegment bulge = make_segment(arc, *descriptor);
    const CurveSegment dent = make_segment(test::reversed(arc), *descriptor);
    EXPECT_TRUE(bulge.bulges);
    EXPECT_FALSE(dent.bulges);
    EXPECT_NEAR(bulge.length, 2.4f, 1e-3f);
    EXPECT_LT(norm(bulge.points.front() - arc.front()) + norm(bulge.points.back() - arc.back()), 1e-5f);
    EXPECT_LT(norm(dent.points.front() - arc.back()), 1e-5f);
    EXPECT_LT(descriptor->distance(bulge.description, dent.description), 1e-4f) << descriptor->name();
    EXPECT_GT(std::abs(bulge.description[0]), 0);
  }
}

TEST(Silhouettes, OfEachClassTheFirst) {
  std::vector<Silhouette> all;
  for (const char* name : {"bone-1", "bone-10", "cup-2", "cup-3", "tree"}) all.push_back({name, {}});
  const std::vector<Silhouette> first = first_of_each_class(std::move(all));
  ASSERT_EQ(first.size(), 3u);
  EXPECT_EQ(first[0].name, "bone-1");
  EXPECT_EQ(first[1].name, "cup-2");
  EXPECT_EQ(first[2].name, "tree");
}

Setting quick_race(const test::ScratchFolder& folder) {
  return {.quick = true, .devices = "all", .out = folder.path("race.json")};
}

TEST(Descriptors, RaceOnFormulaShapes) {
  const test::ScratchFolder folder;
  const Report report = bench_descriptors(quick_race(folder), {.minutes = 0.5});
  EXPECT_EQ(report.json.at("benchmark"), "descriptors");
  EXPECT_EQ(report.json.at("shapes"), 6);
  const Json& rows = report.json.at("rows");
  ASSERT_EQ(rows.size(), 3u);
  for (const Json& row : rows) {
    EXPECT_GE(row.at("pieces").get<int>(), 3) << report.text;
    EXPECT_LE(row.at("pieces").get<int>(), 5) << "each once, and one is the seed";
    EXPECT_GT(row.at("comparisons").get<double>(), 1000);
    EXPECT_GT(row.at("pieces_per_processor_minute").get<double>(), 0);
    EXPECT_GT(row.at("coverage_percent").get<double>(), 20);
    EXPECT_LT(row.at("overlap_percent").get<double>(), 1);
    EXPECT_EQ(row.at("pieces_at_s").back().at(1), row.at("pieces"));
  }
  EXPECT_EQ(rows[0].at("descriptor"), "PAD");
  EXPECT_GT(rows[0].at("pieces_per_processor_minute").get<double>(),
            3 * rows[1].at("pieces_per_processor_minute").get<double>());
  for (const char* file : {"race.svg", "race.png", "race_PAD.png", "race_shape-context.png", "race_Hu-moments.png"}) {
    EXPECT_GT(std::filesystem::file_size(folder.path(file)), 100u) << file;
  }
}

TEST(Descriptors, EndsAtItsLimits) {
  const test::ScratchFolder folder;
  const Report report = bench_descriptors(quick_race(folder), {.minutes = 0.5, .pieces = 2});
  for (const Json& row : report.json.at("rows")) {
    EXPECT_EQ(row.at("pieces"), 2);
    EXPECT_EQ(row.at("stopped_by"), "pieces");
  }
  const Report none = bench_descriptors(quick_race(folder), {.minutes = 1e-7});
  for (const Json& row : none.json.at("rows")) {
    EXPECT_EQ(row.at("pieces"), 0);
    EXPECT_EQ(row.at("stopped_by"), "time_limit");
  }
}

TEST(Descriptors, TellsAtOnceWhatCannotBeWritten) {
  const test::ScratchFolder folder;
  std::filesystem::create_directory(folder.path("race_Hu-moments.png"));
  try {
    bench_descriptors(quick_race(folder), {.minutes = 0.01});
    FAIL() << "wrote a picture where a folder stands";
  } catch (const std::exception& error) {
    EXPECT_NE(std::string(error.what()).find("race_Hu-moments.png"), std::string::npos) << error.what();
  }
  EXPECT_FALSE(std::filesystem::exists(folder.path("race_PAD.png"))) << "told after the work";
}

TEST(Descriptors, TakesOneSilhouetteOfEachClass) {
  const test::ScratchFolder folder;
  for (const char* name : {"a-1", "a-2", "b-1", "c-1"}) {
    test::write_png(folder.path(std::string(name) + ".png"), test::blob_mask(std::uint64_t(name[0] + name[2])));
  }
  const Report report = bench_descriptors(quick_race(folder), {.shapes = folder.path(""), .pieces = 1});
  EXPECT_EQ(report.json.at("shapes"), 3);
}

std::string complaint_of_race(const DescriptorsOptions& options, const test::ScratchFolder& folder) {
  try {
    bench_descriptors(quick_race(folder), options);
  } catch (const InputError& error) {
    return error.what();
  }
  return "none";
}

TEST(Descriptors, RefusesWhatItCannotDo) {
  const test::ScratchFolder folder;
  EXPECT_EQ(complaint_of_race({.minutes = 0}, folder), "--minutes: found 0; allowed: more than 0, up to 1440");
  EXPECT_EQ(complaint_of_race({.minutes = std::nan("")}, folder),
            "--minutes: found nan; allowed: more than 0, up to 1440");
  EXPECT_EQ(complaint_of_race({.pieces = -1}, folder), "--pieces: found -1; allowed: 1 to 1000, or 0 for no limit");
  const std::string missing = complaint_of_race({.shapes = folder.path("missing")}, folder);
  EXPECT_NE(missing.find("--shapes: cannot read the folder"), std::string::npos) << missing;
  test::write_png(folder.path("a-1.png"), test::blob_mask(1));
  test::write_png(folder.path("a-2.png"), test::blob_mask(2));
  const std::string one = complaint_of_race({.shapes = folder.path("")}, folder);
  EXPECT_EQ(one.find("--shapes: found silhouettes of 1 class in "), 0u) << one;
}

}  // namespace test_segments
}  // namespace tessera::bench
