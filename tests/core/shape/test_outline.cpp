// Outlines of silhouettes: which parts are kept, and why some silhouettes are skipped.
#include "core/shape/outline.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>

#include "core/geometry/polygon.h"

namespace tessera {
namespace test_outline {

constexpr double kPi = std::numbers::pi;

/// Coverage from a signed distance (negative inside). Pixel centres are at (i + 0.5, j + 0.5).
Grid<float> silhouette(const std::function<float(Vec2)>& distance_px, int size = 300) {
  Grid<float> alpha(size, size);
  for (int y = 0; y < size; ++y) {
    for (int x = 0; x < size; ++x) {
      alpha(x, y) = std::clamp(0.5f - distance_px({float(x) + 0.5f, float(y) + 0.5f}), 0.f, 1.f);
    }
  }
  return alpha;
}

float to_disc(Vec2 p, Vec2 centre, float radius) { return norm(p - centre) - radius; }
float to_box(Vec2 p, Vec2 centre, Vec2 half) {
  return std::max(std::abs(p.x - centre.x) - half.x, std::abs(p.y - centre.y) - half.y);
}

std::variant<TracedOutline, SkipReason> trace(const std::function<float(Vec2)>& distance_px) {
  return trace_outline(silhouette(distance_px), {}, 0);
}

TracedOutline traced(const std::function<float(Vec2)>& distance_px) {
  const auto result = trace(distance_px);
  if (const auto* reason = std::get_if<SkipReason>(&result))
    throw std::runtime_error("skipped: reason " + std::to_string(int(*reason)));
  return std::get<TracedOutline>(result);
}

SkipReason reason(const std::function<float(Vec2)>& distance_px) { return std::get<SkipReason>(trace(distance_px)); }

TEST(Outline, DiscWithHole) {
  const auto outline = traced([](Vec2 p) {
    return std::max(to_disc(p, {150, 140}, 100), -to_disc(p, {150, 140}, 50));
  });
  ASSERT_EQ(outline.curves.size(), 2u);
  const AreaMoment outer = area_moment(outline.curves[0].even_points(512));
  EXPECT_NEAR(outer.area, kPi * 1e4, 10);
  EXPECT_NEAR(outer.x / outer.area, 150, 0.02);
  EXPECT_NEAR(outer.y / outer.area, 140, 0.02);
  EXPECT_NEAR(outline.curves[0].length(), 2 * kPi * 100, 0.5);
  EXPECT_NEAR(signed_area(outline.curves[1].even_points(512)), -kPi * 2500, 10);
  EXPECT_EQ(outline.other_components, 0);
}

TEST(Outline, StairsOfAHardMaskGo) {
  Grid<float> hard = silhouette([](Vec2 p) { return to_disc(p, {150, 150}, 100); });
  for (float& a : hard.data()) a = a >= 0.5f ? 1.f : 0.f;
  const auto outline = std::get<TracedOutline>(trace_outline(hard, {}, 1));
  for (const Vec2 p : outline.curves[0].even_points(1000)) EXPECT_NEAR(norm(p - Vec2{150, 150}), 100, 0.6);
  EXPECT_NEAR(outline.curves[0].length(), 2 * kPi * 100, 0.01 * 2 * kPi * 100);
}

TEST(Outline, OriginMovesIt) {
  const auto alpha = silhouette([](Vec2 p) { return to_disc(p, {150, 150}, 100); });
  const auto outline = std::get<TracedOutline>(trace_outline(alpha, {1000, 20}, 0));
  const AreaMoment moment = area_moment(outline.curves[0].even_points(512));
  EXPECT_NEAR(moment.x / moment.area, 1150, 0.02);
  EXPECT_NEAR(moment.y / moment.area, 170, 0.02);
}

TEST(Outline, TinyHolesAreFilled) {
  const auto with_hole = [](float radius) {
    return traced([=](Vec2 p) { return std::max(to_disc(p, {150, 150}, 100), -to_disc(p, {120, 150}, radius)); });
  };
  EXPECT_EQ(with_hole(5).curves.size(), 1u);  // 0.25 % of the area
  EXPECT_EQ(with_hole(7).curves.size(), 2u);  // 0.5 % of the area
}

TEST(Outline, SpecksAreLeftOutAndReported) {
  const auto outline = traced([](Vec2 p) {
    return std::min({to_disc(p, {120, 150}, 80), to_disc(p, {280, 20}, 8), to_disc(p, {280, 280}, 4)});
  });
  EXPECT_EQ(outline.curves.size(), 1u);
  EXPECT_EQ(outline.other_components, 2);
  EXPECT_NEAR(outline.other_area_fraction, 80. / 6400, 5e-4);
}

TEST(Outline, HoleOfAnotherComponentIsNotOurs) {
  // A ring around a smaller ring, whose hole lies in the larger one's hole.
  const auto result = trace([](Vec2 p) {
    const float d = norm(p - Vec2{150, 150});
    return std::min(std::abs(d - 120) - 20, std::abs(d - 15) - 4);
  });
  const auto& outline = std::get<TracedOutline>(result);
  EXPECT_EQ(outline.curves.size(), 2u);
  EXPECT_EQ(outline.other_components, 1);
}

TEST(Outline, SkipsWhatIsOfNoUse) {
  EXPECT_EQ(reason([](Vec2) { return 1.f; }), SkipReason::empty);
  EXPECT_EQ(reason([](Vec2 p) { return to_disc(p, {150, 150}, 10); }), SkipReason::too_small);
  EXPECT_EQ(reason([](Vec2 p) {
              return std::min(to_disc(p, {80, 150}, 60), to_disc(p, {240, 150}, 40));
            }),
            SkipReason::several_large_components);
  EXPECT_EQ(reason([](Vec2 p) { return to_box(p, {150, 150}, {100, 60}); }), SkipReason::plain_rectangle);
  EXPECT_EQ(reason([](Vec2 p) { return std::abs(to_disc(p, {150, 150}, 120)) - 1; }), SkipReason::hairlines);
  EXPECT_EQ(reason([](Vec2 p) { return to_box(p, {150, 150}, {140, 2}); }), SkipReason::hairlines);
}

/// The pixels show a line thinner than a pixel as dashes.
TEST(Outline, DashesOfAThinLineAreNoPartsSideBySide) {
  const auto dashes = [](float line) {
    return [line](Vec2 p) {
      const float angle = std::atan2(p.y - 150, p.x - 150);
      return std::max(std::abs(to_disc(p, {150, 150}, 120)) - line / 2, 6 * std::sin(20 * angle));
    };
  };
  EXPECT_EQ(reason(dashes(0.6f)), SkipReason::hairlines);
  EXPECT_EQ(reason(dashes(8)), SkipReason::several_large_components);
}

TEST(Outline, ABarWithAPointIsNoPlainRectangle) {
  const auto bar = [](float point) {
    return [point](Vec2 p) {
      const float to_point = (p.x - 290) + std::abs(p.y - 150) * point / 20;
      return std::max(to_box(p, {150, 150}, {140, 20}), point > 0 ? to_point : -1);
    };
  };
  EXPECT_EQ(reason(bar(0)), SkipReason::plain_rectangle);
  EXPECT_NO_THROW(traced(bar(15)));
}

TEST(Outline, ARectangleIsKeptWhereItIsAsked) {
  const auto tile = silhouette([](Vec2 p) { return to_box(p, {150, 150}, {100, 60}); });
  EXPECT_TRUE(std::holds_alternative<TracedOutline>(trace_outline(tile, {}, 0, {.keep_rectangles = true})));
  EXPECT_TRUE(std::holds_alternative<SkipReason>(trace_outline(tile, {}, 0)));
}

float to_ring(Vec2 p, Vec2 centre, float radius, float line) { return std::abs(to_disc(p, centre, radius)) - line / 2; }

/// The distance to two rings and a bridge between them.
float to_spectacles(Vec2 p) {
  return std::min({to_ring(p, {80, 150}, 50, 10), to_ring(p, {220, 150}, 50, 10), to_box(p, {150, 150}, {25, 5})});
}

TEST(Outline, HollownessIsWhatIsEnclosedInPartsOfWhatIsCovered) {
  EXPECT_EQ(traced([](Vec2 p) { return to_disc(p, {150, 150}, 100); }).hollowness, 1);
  EXPECT_NEAR(traced([](Vec2 p) { return to_ring(p, {150, 150}, 90, 20); }).hollowness, 1e4 / (1e4 - 6400), 0.01);
  EXPECT_GT(traced(to_spectacles).hollowness, 2.2f);
}

TEST(Outline, WhatIsEnclosedCountsWhereItIsAsked) {
  const auto filled = [](const std::function<float(Vec2)>& distance_px) {
    return std::get<TracedOutline>(trace_outline(silhouette(distance_px), {}, 0, {.fill_holes = true}));
  };
  const TracedOutline spectacles = filled(to_spectacles);
  EXPECT_EQ(traced(to_spectacles).curves.size(), 3u);
  ASSERT_EQ(spectacles.curves.size(), 1u);
  EXPECT_NEAR(area_moment(spectacles.curves[0].even_points(2048)).area, 2 * kPi * 55 * 55 + 30 * 10, 60);
  EXPECT_GT(spectacles.hollowness, 2.2f);
  // A hub within a wheel and a thin line around both. Without the line they would be two large parts.
  const TracedOutline wheel = filled([](Vec2 p) {
    return std::min({to_ring(p, {150, 150}, 100, 10), to_disc(p, {150, 150}, 40), to_disc(p, {280, 280}, 5)});
  });
  EXPECT_EQ(wheel.curves.size(), 1u);
  EXPECT_EQ(wheel.other_components, 1) << "what lies outside";
  EXPECT_EQ(filled([](Vec2 p) { return to_ring(p, {150, 150}, 120, 2); }).curves.size(), 1u);
}

TEST(Outline, UsesWhatIsNearTheLimits) {
  EXPECT_NO_THROW(traced([](Vec2 p) { return to_disc(p, {150, 150}, 14.5f); }));
  EXPECT_NO_THROW(traced([](Vec2 p) { return to_box(p, {150, 150}, {140, 12}) + std::abs(p.x - 150) / 12; }));
  // A disc with whiskers keeps more than 70 % of its area.
  EXPECT_NO_THROW(traced([](Vec2 p) {
    return std::min(to_disc(p, {150, 150}, 70), to_box(p, {150, 150}, {140, 1.5f}));
  }));
}

TEST(Outline, PixelsOfTheSourceCount) {
  const auto alpha = silhouette([](Vec2 p) { return to_disc(p, {150, 150}, 100); });
  EXPECT_TRUE(std::holds_alternative<TracedOutline>(trace_outline(alpha, {}, 4)));
  EXPECT_EQ(std::get<SkipReason>(trace_outline(alpha, {}, 10)), SkipReason::too_small);  // an icon of 18 px
}

}  // namespace test_outline
}  // namespace tessera
