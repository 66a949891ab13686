// Translucent parts belong to a silhouette; soft shadows and halos do not.
#include "artwork/solid_coverage.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <opencv2/imgproc.hpp>

#include "artwork/artwork_shape.h"
#include "support/artwork_samples.h"

namespace tessera {
namespace test_solid_coverage {

using test::Bytes;
using test::encoded;

constexpr double kBody = CV_PI * 20 * 20;  // a disc in the middle of a page of 200 x 100
constexpr double kBesideBody =
    2 * 28.54 * 16;  // the part of the wings beside the body; they are bars that begin below it

const std::string kBodyDisc = R"~(<circle cx="100" cy="50" r="20" fill="#c02020"/>)~";

Bytes page(const std::string& body) { return test::svg(body, R"~(width="200" height="100" viewBox="0 0 200 100")~"); }

std::string wings(double opacity, const std::string& attributes = "") {
  const std::string bar = R"~(" y="42" width="40" height="16" fill="#60a0ff" fill-opacity=")~" +
                          std::to_string(opacity) + "\" " + attributes + "/>";
  return "<rect x=\"52" + bar + "<rect x=\"108" + bar;
}

/// An element, for example `circle r="5"`, with a blur of `blur` units.
std::string blurred(const std::string& element, double blur, double opacity = 1) {
  return R"~(<filter id="f" x="-1" y="-1" width="3" height="3"><feGaussianBlur stdDeviation=")~" +
         std::to_string(blur) + "\"/></filter><" + element + " filter=\"url(#f)\" opacity=\"" +
         std::to_string(opacity) + "\"/>";
}

/// A disc of radius 40 that fades out beyond the fraction `from` of its radius.
std::string fading_disc(double from, double opacity, double y = 50) {
  return "<radialGradient id=\"g\"><stop offset=\"" + std::to_string(from) + "\" stop-opacity=\"" +
         std::to_string(opacity) + R"~("/><stop offset="1" stop-opacity="0"/></radialGradient><circle cx="100" cy=")~" +
         std::to_string(y) + R"~(" r="40" fill="url(#g)"/>)~";
}

std::variant<ArtworkShape, SkipReason> traced(const Bytes& file, float edge_opacity = kEdgeOpacity) {
  return shape_from_artwork(file, "drawing.svg", {.pad = {}, .rules = {.edge_opacity = edge_opacity}});
}

/// The area of the shape in units of the page; 0 if there is no shape.
double area(const Bytes& file, float edge_opacity = kEdgeOpacity) {
  const auto result = traced(file, edge_opacity);
  const auto* artwork = std::get_if<ArtworkShape>(&result);
  return artwork ? double(artwork->shape.drawn_scale_px) * double(artwork->shape.drawn_scale_px) : 0;
}

TEST(SolidCoverage, WingsOfAnyOpacityBelongToTheBody) {
  const double opaque = area(page(wings(1) + kBodyDisc));
  EXPECT_NEAR(opaque, kBody + kBesideBody, 0.01 * opaque);
  for (const double opacity : {0.08, 0.12, 0.2, 0.25, 0.4, 0.49, 0.5, 0.7, 0.9}) {
    EXPECT_NEAR(area(page(wings(opacity) + kBodyDisc)), opaque, 0.01 * opaque) << opacity;
    EXPECT_NEAR(area(page(kBodyDisc + wings(opacity))), opaque, 0.01 * opaque) << opacity << ", before the body";
  }
}

TEST(SolidCoverage, WingsMayHaveAnOutlineOrAGradient) {
  for (const char* outline : {"stroke=\"#203040\"", "stroke=\"#203040\" stroke-opacity=\"0.4\"",
                              "stroke=\"#203040\" stroke-width=\"3\"", "stroke=\"#203040\" stroke-width=\"6\""}) {
    const double opaque = area(page(wings(1, outline) + kBodyDisc));
    EXPECT_NEAR(area(page(wings(0.4, outline) + kBodyDisc)), opaque, 0.03 * opaque) << outline;
  }
  const double opaque = area(page(wings(1) + kBodyDisc));
  const std::string gradient =
      R"~(<linearGradient id="g"><stop stop-opacity="0.3"/><stop offset="1" stop-opacity="0.5"/></linearGradient>)~"
      R"~(<path d="M52 42h40v16h-40z M108 42h40v16h-40z" fill="url(#g)"/>)~";
  EXPECT_NEAR(area(page(gradient + kBodyDisc)), opaque, 0.01 * opaque);
}

TEST(SolidCoverage, ADrawingMayBeTranslucentAsAWhole) {
  const std::string leaf = R"~(<path d="M60 50Q100 10 140 50Q100 90 60 50z" fill="#30a030" opacity=")~";
  const double opaque = area(page(leaf + "1\"/>"));
  for (const char* opacity : {"0.09", "0.19", "0.25", "0.4", "0.8"}) {
    EXPECT_NEAR(area(page(leaf + opacity + "\"/>")), opaque, 0.005 * opaque) << opacity;
  }
  const auto plain = traced(page(R"~(<path d="M60 50h80v30h-80z" opacity="0.4"/>)~"));
  EXPECT_EQ(std::get<SkipReason>(plain), SkipReason::plain_rectangle);
}

ArtworkShape shape_of(const std::string& drawing) { return std::get<ArtworkShape>(traced(page(drawing))); }

/// A disc whose opacity falls from its middle to its rim, with a visible rim.
std::string ball(double rim_opacity) {
  return R"~(<radialGradient id="b"><stop stop-opacity="0.9"/><stop offset="1" stop-opacity=")~" +
         std::to_string(rim_opacity) + R"~("/></radialGradient><circle cx="100" cy="50" r="40" fill="url(#b)"/>)~";
}

TEST(SolidCoverage, WhatEndsAtAnEdgeCountsToItsEnd) {
  const double disc = CV_PI * 40 * 40;
  for (const double rim : {0.1, 0.3, 0.45}) EXPECT_NEAR(area(page(ball(rim))), disc, 0.01 * disc) << rim;
  const std::string string = R"~(<path d="M137 48h60v4h-60z"/>)~";
  EXPECT_NEAR(area(page(ball(0.3) + string)), disc + 57 * 4, 0.01 * disc);
}

TEST(SolidCoverage, TranslucentLinesAndSpotsBelongToTheBody) {
  for (const char* opacity : {"0.2", "0.35", "0.6"}) {
    const std::string jellyfish =
        std::string("<g opacity=\"") + opacity + R"~("><path d="M60 50a40 40 0 0 1 80 0z"/>)~";
    const double dome = area(page(jellyfish + "</g>"));
    const std::string arms = R"~(<path d="M70 49v45M100 49v45M130 49v45" stroke="#000" stroke-width="2"/></g>)~";
    EXPECT_NEAR(area(page(jellyfish + arms)), dome + 3 * 44 * 2, 0.01 * dome) << opacity;
  }
  const std::string ears = R"~(<path d="M88 38l-14 -10l16 2zM112 38l14 -10l-16 2z" opacity="0.4"/>)~";
  EXPECT_GT(area(page(kBodyDisc + ears)), kBody + 60);
}

TEST(SolidCoverage, WhiskersOfAnySlopeBelongToTheBody) {
  for (const double slope : {0., 0.15, 0.3, 0.7}) {
    const std::string ends = std::to_string(60 * slope) + "h0";
    const std::string whisker = "<path d=\"M100 50l60 -" + ends + "M100 50l-60 -" + ends;
    const double outside = 2 * 2 * (60 * std::hypot(1, slope) - 20);
    EXPECT_NEAR(area(page(whisker + R"~(" stroke="#000" stroke-width="2" opacity="0.4"/>)~" + kBodyDisc)),
                kBody + outside, 0.02 * kBody)
        << slope;
  }
}

/// A fading wing without an edge ends where half of its opacity is reached.
TEST(SolidCoverage, AWingThatFadesAtItsTipCountsToItsHalf) {
  const auto wing = [](const std::string& tip) {
    return R"~(<linearGradient id="g"><stop stop-opacity="0.6"/><stop offset="1" stop-opacity=")~" + tip +
           R"~("/></linearGradient><path d="M100 42h80v16h-80z" fill="url(#g)"/>)~" + kBodyDisc;
  };
  const double whole = 61 * 16;
  EXPECT_NEAR(area(page(wing("0.1"))), kBody + whole, 0.02 * kBody);
  const double faded = area(page(wing("0")));
  EXPECT_GT(faded, kBody + 0.4 * whole);
  EXPECT_LT(faded, kBody + 0.9 * whole);
  EXPECT_FALSE(shape_of(wing("0")).loses_parts);
}

TEST(SolidCoverage, ASmallDrawingOnALargePageHasItsWings) {
  const std::string drawing = wings(0.3) + kBodyDisc;
  const Bytes large = test::svg(drawing, R"~(width="4000" height="4000" viewBox="-1000 -1000 4000 4000")~");
  EXPECT_NEAR(area(large), area(page(drawing)), 0.03 * area(page(drawing)));
}

TEST(SolidCoverage, WhatIsTooFaintOrTooThinIsTold) {
  EXPECT_FALSE(shape_of(wings(0.4) + kBodyDisc).loses_parts);
  EXPECT_FALSE(shape_of(wings(0.08) + kBodyDisc).loses_parts);
  const ArtworkShape faint = shape_of(wings(0.05) + kBodyDisc);
  EXPECT_TRUE(faint.loses_parts);
  EXPECT_EQ(faint.other_components, 0);
  const std::string hairs =
      R"~(<path d="M100 50L20 10M100 50L20 90M100 50L180 10" stroke="#000" stroke-width="0.15"/>)~";
  EXPECT_TRUE(shape_of(hairs + kBodyDisc).loses_parts);
  const std::string plate = R"~(<rect x="20" y="5" width="160" height="90" fill="#80a0ff" opacity="0.3"/>)~";
  EXPECT_TRUE(shape_of(plate + kBodyDisc).loses_parts);
  EXPECT_FALSE(shape_of(blurred(R"~(ellipse cx="100" cy="74" rx="40" ry="8")~", 4, 0.7) + kBodyDisc).loses_parts)
      << "soft shadows do not count";
}

TEST(SolidCoverage, WhereTheFaintPartsMakeTheDrawingTheReasonIsThat) {
  const std::string ghost = R"~(<path d="M70 90v-50a30 30 0 0 1 60 0v50z" opacity=")~";
  const std::string eyes = R"~(<circle cx="90" cy="40" r="6"/><circle cx="110" cy="40" r="6"/>)~";
  EXPECT_EQ(shape_of(ghost + "0.18\"/>" + eyes).other_components, 0);
  EXPECT_EQ(std::get<SkipReason>(traced(page(ghost + "0.05\"/>" + eyes))), SkipReason::faint);
  EXPECT_EQ(std::get<SkipReason>(traced(page(ghost + "0.05\"/>"))), SkipReason::faint);
  EXPECT_EQ(std::get<SkipReason>(traced(page(eyes))), SkipReason::several_large_components);
}

TEST(SolidCoverage, GlassInAFrameIsNoHole) {
  const std::string frame =
      R"~(<circle cx="100" cy="50" r="35" stroke="#404040" stroke-width="10" fill="#80c0ff" fill-opacity=")~";
  const double opaque = area(page(frame + "1\"/>"));
  EXPECT_NEAR(area(page(frame + "0.3\"/>")), opaque, 0.002 * opaque);
  EXPECT_LT(area(page(frame + "0.05\"/>")), 0.6 * opaque) << "nobody sees it";
}

TEST(SolidCoverage, SoftShadowsAreLeftOut) {
  const double body = area(page(kBodyDisc));
  for (const double strength : {0.3, 0.6, 0.9}) {
    const std::string dropped =
        R"~(<filter id="d" x="-1" y="-1" width="3" height="3"><feGaussianBlur in="SourceAlpha" stdDeviation="3"/>)~"
        R"~(<feOffset dx="4" dy="4"/><feComponentTransfer><feFuncA type="linear" slope=")~" +
        std::to_string(strength) +
        R"~("/></feComponentTransfer><feMerge><feMergeNode/><feMergeNode in="SourceGraphic"/>)~" +
        "</feMerge></filter><g filter=\"url(#d)\">" + kBodyDisc + "</g>";
    for (const std::string& drawing :
         {blurred(R"~(circle cx="104" cy="56" r="20")~", 3, strength) + kBodyDisc,
          fading_disc(0.4, strength, 56) + kBodyDisc,
          blurred(R"~(ellipse cx="100" cy="74" rx="40" ry="8")~", 4, strength) + kBodyDisc,
          blurred(R"~(ellipse cx="100" cy="85" rx="30" ry="5")~", 3, strength) + kBodyDisc, dropped}) {
      EXPECT_NEAR(area(page(drawing)), body, 0.02 * body) << drawing;
    }
  }
}

/// Some programs draw soft shadows as stacked discs of opacity 0.05.
TEST(SolidCoverage, ASoftShadowMayBeMadeOfSteps) {
  std::string steps;
  for (int radius = 22; radius <= 38; radius += 4) {
    steps += "<circle cx=\"104\" cy=\"54\" fill-opacity=\"0.05\" r=\"" + std::to_string(radius) + "\"/>";
  }
  EXPECT_NEAR(area(page(steps + kBodyDisc)), kBody, 0.02 * kBody);
}

TEST(SolidCoverage, AShadowIsNoWingAndAWingIsNoShadow) {
  const double opaque = area(page(wings(1) + kBodyDisc));
  const std::string shadow = blurred(R"~(ellipse cx="100" cy="72" rx="30" ry="8")~", 3, 0.7);
  EXPECT_NEAR(area(page(shadow + wings(0.4) + kBodyDisc)), opaque, 0.03 * opaque);
}

/// A user who asks for shadows gets them.
TEST(SolidCoverage, AnOpacityThatIsAskedForIsTakenByTheWord) {
  EXPECT_GT(area(page(fading_disc(0.4, 0.8) + kBodyDisc), 0.05f), 2 * kBody);
  EXPECT_NEAR(area(page(wings(0.4) + kBodyDisc), 0.6f), kBody, 0.01 * kBody);
  EXPECT_GT(area(page(wings(0.4) + kBodyDisc), 0.3f), kBody + 0.9 * kBesideBody);
}

TEST(SolidCoverage, ImagesWithSoftAlphaToo) {
  for (const int side_px : {96, 300, 1200}) {
    const double unit = side_px / 100.;
    const auto disc = [&](double x, double y, double r) {
      cv::Mat drawn(side_px, side_px, CV_8U, cv::Scalar(0));
      cv::circle(drawn, {int(x * unit), int(y * unit)}, int(r * unit), cv::Scalar(255), cv::FILLED, cv::LINE_AA);
      return drawn;
    };
    const cv::Mat body = disc(50, 50, 25), wing = disc(50, 22, 15);
    cv::Mat shadow = disc(54, 56, 25), silhouette;
    cv::GaussianBlur(shadow, shadow, {0, 0}, 3 * unit);
    const cv::Mat faint_shadow = shadow * 0.7, faint_wing = wing * 0.4;
    cv::Mat picture(side_px, side_px, CV_8UC4, cv::Scalar(40, 80, 160, 0));
    cv::insertChannel(cv::max(cv::max(faint_shadow, faint_wing), body), picture, 3);
    cv::bitwise_or(body, wing, silhouette);
    const double wanted_px2 = cv::sum(silhouette)[0] / 255;
    EXPECT_NEAR(area(encoded(picture, ".png")), wanted_px2, 0.03 * wanted_px2) << side_px;
  }
}

TEST(SolidCoverage, WhatIsBlurredItselfEndsHalfWay) {
  const double disc = CV_PI * 30 * 30;
  EXPECT_NEAR(area(page(blurred(R"~(circle cx="100" cy="50" r="30")~", 3))), disc, 0.03 * disc);
  const double cloud = CV_PI * 15 * 15;
  EXPECT_NEAR(area(page(fading_disc(0, 0.8))), cloud, 0.05 * cloud);
}

TEST(SolidCoverage, ATranslucentPlateBehindDoesNotCostTheDrawing) {
  const std::string plate = R"~(<rect x="20" y="5" width="160" height="90" fill="#80a0ff" opacity="0.3"/>)~";
  EXPECT_NEAR(area(page(plate + kBodyDisc)), kBody, 0.01 * kBody);
}

TEST(SolidCoverage, ATranslucentPartBesideTheBodyIsNotOfIt) {
  const std::string far = R"~(<rect x="150" y="20" width="40" height="60" fill-opacity="0.4"/>)~";
  EXPECT_NEAR(area(page(far + kBodyDisc)), kBody, 0.01 * kBody);
  EXPECT_EQ(shape_of(far + kBodyDisc).other_components, 1);
  EXPECT_EQ(shape_of(far + R"~(<circle cx="20" cy="50" r="2"/>)~" + kBodyDisc).other_components, 2);
}

/// The coverage is equal to the byte, so libraries of such drawings stay unchanged.
RC_GTEST_PROP(SolidCoverage, WithoutTranslucentPartsItIsAlphaItself, ()) {
  cv::Mat alpha(200, 200, CV_8U, cv::Scalar(0));
  const int shapes = *rc::gen::inRange(1, 6);
  for (int i = 0; i < shapes; ++i) {
    std::vector<std::vector<cv::Point>> polygon(1);
    for (int k = 0; k < 5; ++k) polygon[0].emplace_back(*rc::gen::inRange(0, 200), *rc::gen::inRange(0, 200));
    const int line_px = *rc::gen::inRange(0, 7);
    if (line_px == 0) cv::fillPoly(alpha, polygon, cv::Scalar(255), cv::LINE_AA);
    if (line_px > 0) cv::polylines(alpha, polygon, true, cv::Scalar(255), line_px, cv::LINE_AA);
  }
  RC_ASSERT(cv::norm(solid_coverage(alpha, 0).coverage, alpha, cv::NORM_INF) == 0);
}

}  // namespace test_solid_coverage
}  // namespace tessera
