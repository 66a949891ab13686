// Collages whose pieces show a picture: dark pieces in its dark areas.
#include <gtest/gtest.h>

#include <cmath>

#include "support/colours.h"
#include "whole_collage.h"

namespace tessera {
namespace test_colours {

using namespace whole_collage;

const Lab kDark{15, 0, 0};
const Lab kLight{90, 5, 20};

/// A library in which every other shape is dark.
std::vector<Shape> two_coloured_library() {
  std::vector<Shape> shapes = library();
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    const Lab& colour = i % 2 == 0 ? kDark : kLight;
    shapes[i].colour_grid = test::two_toned_grid(colour, colour);
    shapes[i].mean_lab = {colour.lightness, colour.a, colour.b};
  }
  return shapes;
}

const Canvas& canvas() {
  static const Canvas made = make_rectangle_canvas(320, 240);
  return made;
}

/// Settings with a picture that is dark on the left.
CollageSettings coloured(float weight) {
  CollageSettings s = settings();
  std::vector<Lab> of_shapes;
  for (const Shape& shape : two_coloured_library()) {
    of_shapes.push_back({shape.mean_lab[0], shape.mean_lab[1], shape.mean_lab[2]});
  }
  s.colour = test::wish_for(test::picture(320, 240, [](Vec2 p) { return test::opaque(p.x < 160 ? kDark : kLight); }),
                            of_shapes, weight);
  return s;
}

master::CollageResult run_coloured(const CollageSettings& s, std::vector<std::uint32_t> cuts = {}) {
  const std::vector<Shape> shapes = two_coloured_library();
  const MatchingContext context = make_matching_context(s, std::uint32_t(shapes.size()));
  CompositeMatcher matcher = test::divided_matcher(shapes, context, std::move(cuts));
  test::VectorShapes source(shapes);
  master::SilentObserver silent;
  return master::make_collage(canvas(), s, matcher, source, silent);
}

/// The share of the pieces' area whose centre is in the half of its own colour.
double in_place(const std::vector<Placement>& placements) {
  double right = 0, all = 0;
  for (const Placement& p : placements) {
    const double area = double(p.canvas_from_shape.scale()) * p.canvas_from_shape.scale();
    const bool dark = index_of(p.shape) % 2 == 0;
    all += area;
    if (dark == (p.canvas_from_shape.tx < 160)) right += area;
  }
  return right / all;
}

TEST(Colours, PiecesShowThePicture) {
  const master::CollageResult result = run_coloured(coloured(1));
  EXPECT_GT(in_place(result.placements), 0.9);
  EXPECT_LT(in_place(run_coloured(settings()).placements), 0.75) << "without a picture they lie anywhere";
  EXPECT_GT(quality(canvas(), result).coverage, 0.8);
}

TEST(Colours, OfNoWeightChangeNothing) {
  EXPECT_EQ(run_coloured(coloured(0)).placements, run_coloured(settings()).placements);
}

TEST(Colours, DoNotDependOnTheDivisionOfTheLibrary) {
  const master::CollageResult whole = run_coloured(coloured(1));
  EXPECT_EQ(run_coloured(coloured(1), {3, 4, 9}).placements, whole.placements);
}

/// Only small pieces are allowed on the left.
TEST(Colours, SizesGoByPlace) {
  CollageSettings s = settings();
  SizeMap map{Grid<float>(32, 24, 1.f), 0.1f};
  for (int y = 0; y < 24; ++y) std::fill_n(map.part.row(y), 16, 0.3f);
  s.pieces.size_map = std::make_shared<const SizeMap>(map);
  const master::CollageResult result = run_coloured(s);
  EXPECT_EQ(run_coloured(s, {5}).placements, result.placements);
  const float small_px = 20 * std::exp2(0.3f * std::log2(90.f / 20));
  float largest_px = 0;
  for (const Placement& p : result.placements) {
    const float scale_px = p.canvas_from_shape.scale();
    largest_px = std::max(largest_px, scale_px);
    if (p.canvas_from_shape.tx < 150) {
      EXPECT_LE(scale_px, small_px * 1.05f) << "at " << p.canvas_from_shape.tx;
    }
  }
  EXPECT_GT(largest_px, 60);
  EXPECT_GT(quality(canvas(), result).coverage, 0.8);
}

/// The share of pairs of neighbours with alike colours.
double like_neighbours(const std::vector<Placement>& placements) {
  int like = 0, all = 0;
  for (const Placement& p : placements) {
    for (const Placement& q : placements) {
      const Vec2 apart = p.canvas_from_shape.translation() - q.canvas_from_shape.translation();
      const float near_px = 0.75f * (p.canvas_from_shape.scale() + q.canvas_from_shape.scale());
      if (&p == &q || dot(apart, apart) >= near_px * near_px) continue;
      ++all;
      if (index_of(p.shape) % 2 == index_of(q.shape) % 2) ++like;
    }
  }
  return double(like) / all;
}

TEST(Colours, NeighboursAreAlikeOrUnlike) {
  const auto neighbours = [](float weight, std::uint64_t seed = settings().seed) {
    CollageSettings s = coloured(1);
    s.seed = seed;
    s.colour.target = nullptr;
    s.colour.neighbours = weight;
    return s;
  };
  constexpr int kSeeds = 12;  // single seeds differ by a tenth
  double alike = 0, not_alike = 0;
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    alike += like_neighbours(run_coloured(neighbours(1, seed)).placements) / kSeeds;
    not_alike += like_neighbours(run_coloured(neighbours(-1, seed)).placements) / kSeeds;
  }
  EXPECT_GT(alike, 0.7);
  EXPECT_LT(not_alike, 0.4);
  const master::CollageResult unlike = run_coloured(neighbours(-1));
  EXPECT_GT(quality(canvas(), unlike).coverage, 0.8);
  EXPECT_EQ(run_coloured(neighbours(-1), {2, 7}).placements, unlike.placements);
  EXPECT_EQ(run_coloured(neighbours(0)).placements, run_coloured(settings()).placements);
}

/// A place is filled even if no shape has its colour.
TEST(Colours, LeaveNoPlaceEmpty) {
  CollageSettings s = coloured(3);
  s.colour.target = test::picture(320, 240, [](Vec2) { return test::opaque({50, -80, 70}); });
  EXPECT_GT(quality(canvas(), run_coloured(s)).coverage, 0.8);
}

}  // namespace test_colours
}  // namespace tessera
