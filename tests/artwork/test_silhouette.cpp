// From artwork to silhouette, picture and shape: every format, small and large drawings.
#include "artwork/open_artwork_page.h"
#include "artwork/silhouette.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "artwork/artwork_render.h"
#include "artwork/artwork_shape.h"
#include "artwork/images/artwork_page.h"
#include "core/base/error.h"
#include "support/artwork_samples.h"
#include "support/images.h"

namespace tessera {
namespace test_silhouette {

using test::area_fraction;
using test::area_px2;
using test::Bytes;
using test::disc_with_alpha;
using test::encoded;
using test::kDisc;
using test::svg;

constexpr double kPi = std::numbers::pi;
/// OpenCV draws circles up to half a pixel larger than requested.
constexpr double kDiscFraction = kPi * 60.25 * 60.25 / (300 * 200);

cv::Mat disc_on_background(cv::Scalar background, cv::Scalar disc) {
  cv::Mat image(200, 300, CV_8UC3, background);
  cv::circle(image, {150, 100}, 60, disc, cv::FILLED, cv::LINE_AA);
  return image;
}

Shape shape_of(const Bytes& bytes) {
  const auto result = shape_from_artwork(bytes, "folder/blue bird.svg", {});
  if (const auto* reason = std::get_if<SkipReason>(&result))
    throw std::runtime_error("skipped: reason " + std::to_string(int(*reason)));
  return std::get<ArtworkShape>(result).shape;
}

TEST(Silhouette, SvgPageAndDrawing) {
  const Silhouette s = make_silhouette(svg(kDisc), "a.svg");
  EXPECT_EQ(s.source_px, 0);
  // The drawing takes 40 of 100 units, so it is drawn finer than its page would be at 512.
  EXPECT_GT(s.width_px, 1000);
  EXPECT_EQ(s.height_px, (s.width_px + 1) / 2);
  EXPECT_GE(std::max(s.alpha.width(), s.alpha.height()), 480);
  EXPECT_LE(std::max(s.alpha.width(), s.alpha.height()), kSilhouetteSide_px + 8);
  EXPECT_NEAR(area_fraction(s), kPi * 400 / 5000, 1e-3);
}

TEST(Silhouette, MeanColourIsLab) {
  const auto lab = make_silhouette(svg(kDisc), "a.svg").colour.mean_lab;
  EXPECT_NEAR(lab[0], 53.2, 0.5);  // sRGB red
  EXPECT_NEAR(lab[1], 80.1, 0.5);
  EXPECT_NEAR(lab[2], 67.2, 0.5);
}

/// Black and white in equal shares are each 50 away from their mean.
TEST(Silhouette, SpreadTellsOneColourFromSeveral) {
  EXPECT_LT(make_silhouette(svg(kDisc), "a.svg").colour.spread, 1);
  const std::string halves = R"(<rect width="50" height="50"/><rect x="50" width="50" height="50" fill="white"/>)";
  EXPECT_NEAR(make_silhouette(svg(halves), "a.svg").colour.spread, 50, 1);
}

TEST(Silhouette, ThumbnailIsTheWholePageWithStraightAlpha) {
  const Silhouette s = make_silhouette(svg(R"(<rect width="50" height="50" fill="#00ff00" opacity="0.5"/>)"), "a.svg");
  const cv::Mat image = test::decoded(s.thumbnail_png);
  ASSERT_EQ(image.type(), CV_8UC4);
  EXPECT_EQ(image.size(), cv::Size(192, 96));
  const cv::Vec4b left = image.at<cv::Vec4b>(48, 48);
  EXPECT_NEAR(left[1], 255, 2);
  EXPECT_NEAR(left[3], 128, 2);
  EXPECT_EQ(image.at<cv::Vec4b>(48, 150)[3], 0);
}

TEST(Silhouette, TinyDrawingOnALargePage) {
  const Silhouette s =
      make_silhouette(svg(R"(<circle cx="900" cy="900" r="20"/>)", R"(width="1000" height="1000")"), "a");
  EXPECT_EQ(s.width_px, 2048);
  EXPECT_NEAR(area_fraction(s), kPi * 400 / 1e6, 1e-5);
  const Shape shape = shape_of(svg(R"(<circle cx="900" cy="900" r="20"/>)", R"(width="1000" height="1000")"));
  EXPECT_NEAR(shape.artwork.centroid_px.x, 0.9 * 2048, 0.1);
  EXPECT_NEAR(shape.artwork.unit_px, 2.048 * 20 * std::sqrt(kPi), 0.1);
}

TEST(Silhouette, SizeOfThePage) {
  // The page comes from the viewBox, from other units, or with another aspect. Without any size it ends where the drawing ends.
  EXPECT_NEAR(area_fraction(make_silhouette(svg(kDisc, R"(viewBox="0 0 100 50")"), "a")), kPi * 400 / 5000, 1e-3);
  EXPECT_NEAR(area_fraction(make_silhouette(svg(kDisc, ""), "a")), kPi * 400 / (50 * 45), 2e-3);
  EXPECT_NEAR(area_fraction(make_silhouette(svg(kDisc, R"(width="2in" height="1in" viewBox="0 0 100 50")"), "a")),
              kPi * 400 / 5000, 1e-3);
  EXPECT_NEAR(area_fraction(make_silhouette(svg(kDisc, R"(width="100" height="100" viewBox="0 0 100 50")"), "a")),
              kPi * 400 / 10000, 1e-3);
}

TEST(Silhouette, NothingDrawn) {
  const Silhouette s = make_silhouette(svg(""), "a.svg");
  EXPECT_EQ(area_px2(s), 0);
  EXPECT_EQ(s.colour.mean_lab, (std::array<float, 3>{}));
  EXPECT_EQ(std::get<SkipReason>(shape_from_artwork(svg(""), "a.svg", {})), SkipReason::empty);
}

TEST(Silhouette, ImagesWithAlpha) {
  for (const std::string extension : {".png", ".webp", ".tiff"}) {
    const Silhouette s = make_silhouette(encoded(disc_with_alpha(), extension), "a" + extension);
    EXPECT_NEAR(area_fraction(s), kDiscFraction, 5e-3) << extension;
    EXPECT_NEAR(s.colour.mean_lab[1], 80, 2) << extension;
    EXPECT_NEAR(s.source_px, float(s.width_px) / 300, 1e-4) << extension;
  }
}

TEST(Silhouette, SixteenBitsAndGrey) {
  cv::Mat deep;
  disc_with_alpha().convertTo(deep, CV_16U, 257);
  EXPECT_NEAR(area_fraction(make_silhouette(encoded(deep, ".png"), "a")), kDiscFraction, 5e-3);
  cv::Mat grey;
  cv::cvtColor(disc_on_background(cv::Scalar::all(255), cv::Scalar::all(0)), grey, cv::COLOR_BGR2GRAY);
  EXPECT_NEAR(area_fraction(make_silhouette(encoded(grey, ".png"), "a")), kDiscFraction, 5e-3);
}

TEST(Silhouette, MasksWithoutAlpha) {
  const cv::Mat black_on_white = disc_on_background(cv::Scalar::all(255), cv::Scalar::all(0));
  const cv::Mat white_on_black = disc_on_background(cv::Scalar::all(0), cv::Scalar::all(255));
  const cv::Mat blue_on_yellow = disc_on_background({60, 220, 240}, {180, 40, 20});
  for (const std::string extension : {".png", ".bmp", ".jpg"}) {
    for (const cv::Mat& mask : {black_on_white, white_on_black, blue_on_yellow}) {
      const Silhouette s = make_silhouette(encoded(mask, extension), "a" + extension);
      EXPECT_NEAR(area_fraction(s), kDiscFraction, 5e-3) << extension;
    }
  }
  // The mean colour leaves out the background.
  EXPECT_NEAR(make_silhouette(encoded(blue_on_yellow, ".png"), "a").colour.mean_lab[2], -74, 3);
}

/// Half of the frame's edge belongs to the shape, and JPEG adds noise.
TEST(Silhouette, AMaskMayTouchTheEdge) {
  cv::Mat mask(200, 300, CV_8UC3, cv::Scalar::all(250));
  mask(cv::Rect(160, 0, 140, 200)) = cv::Scalar(20, 30, 10);
  EXPECT_NEAR(area_fraction(make_silhouette(encoded(mask, ".jpg"), "a")), 140.0 / 300, 5e-3);
}

/// Stones of many shades lie side by side and fill the frame.
TEST(Silhouette, APhotoThatFillsItsFrameIsRefused) {
  cv::Mat photo(200, 300, CV_8UC3);
  for (int y = 0; y < photo.rows; ++y)
    for (int x = 0; x < photo.cols; ++x) {
      const int shade = 40 + (x / 30 * 37 + y / 30 * 71) % 160;
      photo.at<cv::Vec3b>(y, x) = cv::Vec3b::all(std::uint8_t(shade));
    }
  for (const std::string extension : {".png", ".jpg"}) {
    try {
      make_silhouette(encoded(photo, extension), "wall");
      FAIL();
    } catch (const InputError& error) {
      EXPECT_EQ(std::string(error.what()),
                "wall: a photo without a plain background; cut out what it shows (a library of the elements in it: "
                "tessera library extract)");
    }
  }
}

TEST(Silhouette, OpaqueAlphaIsAMask) {
  cv::Mat image;
  cv::cvtColor(disc_on_background(cv::Scalar::all(255), cv::Scalar::all(0)), image, cv::COLOR_BGR2BGRA);
  EXPECT_NEAR(area_fraction(make_silhouette(encoded(image, ".png"), "a")), kDiscFraction, 5e-3);
}

TEST(Silhouette, PlainImageIsEmpty) {
  const Bytes plain = encoded(cv::Mat(100, 100, CV_8UC3, cv::Scalar(90, 100, 110)), ".jpg");
  EXPECT_EQ(std::get<SkipReason>(shape_from_artwork(plain, "a.jpg", {})), SkipReason::empty);
}

TEST(Silhouette, HardMaskGivesARoundShape) {
  cv::Mat mask(100, 100, CV_8UC1, cv::Scalar(255));
  cv::circle(mask, {50, 50}, 40, cv::Scalar(0), cv::FILLED, cv::LINE_8);
  const Shape shape = shape_of(encoded(mask, ".png"));
  EXPECT_NEAR(shape.perimeter, 2 * std::sqrt(kPi), 0.02 * 2 * std::sqrt(kPi));
}

TEST(ArtworkShape, CarriesNameAndArtwork) {
  const Shape shape = shape_of(svg(kDisc));
  EXPECT_EQ(shape.name, "blue bird");
  EXPECT_TRUE(shape.artwork.path.starts_with("/"));
  EXPECT_TRUE(shape.artwork.path.ends_with("/folder/blue bird.svg"));
  EXPECT_FALSE(shape.artwork.thumbnail_png.empty());
  EXPECT_TRUE(shape.artwork.original.empty());
  EXPECT_NEAR(shape.artwork.centroid_px.x / float(shape.artwork.width_px), 0.3, 1e-3);
  EXPECT_NEAR(shape.artwork.centroid_px.y / float(shape.artwork.height_px), 0.5, 2e-3);
}

TEST(ArtworkShape, KnowsHowLargeItWasDrawn) {
  const float disc_px = 20 * std::sqrt(float(kPi));
  EXPECT_NEAR(shape_of(svg(kDisc)).drawn_scale_px, disc_px, 0.01f * disc_px);
  cv::Mat mask(100, 100, CV_8UC1, cv::Scalar(255));
  cv::circle(mask, {50, 50}, 40, cv::Scalar(0), cv::FILLED, cv::LINE_8);
  EXPECT_NEAR(shape_of(encoded(mask, ".png")).drawn_scale_px, 40 * std::sqrt(kPi), 1);
}

StyleFeatures style_of(const std::string& drawing, const std::string& page = "viewBox=\"0 0 100 100\"") {
  return std::get<ArtworkShape>(shape_from_artwork(svg(drawing, page), "a.svg", {})).style;
}

TEST(ArtworkShape, KnowsItsStyleAtAnySize) {
  const std::string drawing =
      R"svg(<defs><linearGradient id="g"><stop stop-color="#d04020"/><stop offset="1" stop-color="#f0d060"/>
      </linearGradient></defs><circle cx="50" cy="50" r="40" fill="url(#g)" stroke="black" stroke-width="2"/>)svg";
  const StyleFeatures style = style_of(drawing);
  const double unit = 41 * std::sqrt(kPi);
  EXPECT_NEAR(style.line_width, 2 / unit, 0.15 * 2 / unit);
  EXPECT_GT(style.outlined, 0.97f);
  EXPECT_GT(style.shading, 0.8f);
  const StyleFeatures far = style_of(drawing, R"(width="1000" height="1000" viewBox="-300 -100 400 400")");
  EXPECT_LT(style_distance(style_place(style), style_place(far)), 0.3f);
}

/// Line art may be drawn on white or on a transparent ground.
TEST(ArtworkShape, ClosedLinesAreAlikeWithAndWithoutWhiteBetweenThem) {
  const auto ring = [](const std::string& fill) {
    return style_of(R"(<circle cx="50" cy="50" r="40" stroke="black" stroke-width="2" fill=")" + fill + "\"/>");
  };
  EXPECT_LT(style_distance(style_place(ring("white")), style_place(ring("none"))), 0.3f);
  EXPECT_GT(style_distance(style_place(ring("white")), style_place(ring("#208040"))), 1);
}

/// The halo is opaque up to a radius of 12, then fades out up to 24.
TEST(ArtworkShape, TheOutlineRunsAtTheOpacityAskedFor) {
  const Bytes halo = svg(R"svg(<defs><radialGradient id="g"><stop offset="0.5"/><stop offset="1" stop-opacity="0"/>
      </radialGradient></defs><circle cx="50" cy="25" r="24" fill="url(#g)"/>)svg");
  for (const auto& [opacity, radius_px] : {std::pair(0.5f, 18.), {0.1f, 22.8}, {0.9f, 13.2}}) {
    const auto shape = std::get<ArtworkShape>(shape_from_artwork(halo, "halo.svg", {{}, opacity})).shape;
    EXPECT_NEAR(shape.drawn_scale_px, radius_px * std::sqrt(kPi), 0.3) << opacity;
  }
  EXPECT_EQ(std::get<ArtworkShape>(shape_from_artwork(halo, "halo.svg", {})).shape.drawn_scale_px,
            std::get<ArtworkShape>(shape_from_artwork(halo, "halo.svg", {{}, 0.5f})).shape.drawn_scale_px);
}

/// A cut-out of a photo has no wings and no shadow, so that its soft edge alone tells the outline.
TEST(ArtworkShape, OfAnOpaqueDrawingTranslucentPartsAreEdge) {
  const Bytes winged = svg(R"(<circle cx="30" cy="25" r="15"/><circle cx="55" cy="25" r="15" opacity="0.4"/>)");
  const auto size_px = [&](bool opaque) {
    const TracingSettings settings{.pad = {}, .rules = {.opaque = opaque}};
    return std::get<ArtworkShape>(shape_from_artwork(winged, "winged.svg", settings)).shape.drawn_scale_px;
  };
  EXPECT_NEAR(size_px(true), 15 * std::sqrt(kPi), 0.3);
  EXPECT_GT(size_px(false), 1.3f * size_px(true));
}

/// The message advises to fill enclosed areas only if the lines alone are too thin.
TEST(ArtworkShape, SaysWhereWhatItEnclosesWouldHelp) {
  const auto ring = [](double line) {
    return svg(R"(<circle cx="50" cy="25" r="20" fill="none" stroke="black" stroke-width=")" + std::to_string(line) +
               "\"/>");
  };
  const TracingSettings filled{.pad = {}, .rules = {.fill_holes = true}};
  EXPECT_NEAR(std::get<ArtworkShape>(shape_from_artwork(ring(4), "ring.svg", {})).hollowness,
              22. * 22 / (22 * 22 - 18 * 18), 0.03);
  EXPECT_EQ(std::get<SkipReason>(shape_from_artwork(ring(0.3), "ring.svg", {})), SkipReason::hollow);
  const auto disc = std::get<ArtworkShape>(shape_from_artwork(ring(0.3), "ring.svg", filled));
  EXPECT_NEAR(disc.shape.drawn_scale_px, 20.15 * std::sqrt(kPi), 0.1);
  const auto line = svg(R"(<path d="M5 5L95 45" stroke="black" stroke-width="0.3"/>)");
  EXPECT_EQ(std::get<SkipReason>(shape_from_artwork(line, "line.svg", {})), SkipReason::hairlines);
  EXPECT_EQ(std::get<SkipReason>(shape_from_artwork(line, "line.svg", filled)), SkipReason::hairlines);
}

TEST(ArtworkShape, SameSilhouetteGivesTheSameOutline) {
  const Shape red = shape_of(svg(kDisc));
  const Shape blue = shape_of(svg(R"(<circle cx="30" cy="25" r="20" fill="#0000ff"/>)"));
  EXPECT_EQ(red.outline, blue.outline);
  EXPECT_GE(red.colour_spread, 0);
  EXPECT_LT(red.colour_spread, 1);
  EXPECT_NE(red.mean_lab, blue.mean_lab);
}

TEST(ArtworkRender, HasTheSizeAskedForAndStraightAlpha) {
  const cv::Mat image = render_artwork(svg(R"(<rect width="50" height="50" fill="#00ff00" opacity="0.5"/>)"), "a", 301);
  ASSERT_EQ(image.type(), CV_8UC4);
  EXPECT_EQ(image.size(), cv::Size(301, 151));
  EXPECT_NEAR(image.at<cv::Vec4b>(20, 20)[1], 255, 2);
  EXPECT_NEAR(image.at<cv::Vec4b>(20, 20)[3], 128, 1);
  EXPECT_EQ(render_artwork(encoded(disc_with_alpha(), ".png"), "a", 75).size(), cv::Size(75, 50));
  EXPECT_THROW(render_artwork(svg(kDisc), "a", 0), InputError);
  EXPECT_THROW(render_artwork(svg(kDisc), "a", kMaxArtworkSide_px + 1), InputError);
}

TEST(ArtworkPage, WindowIsCutFromThePage) {
  // The drawing has layers, whose look must not depend on the window.
  const auto page = open_artwork_page(svg(R"svg(<filter id="f"><feGaussianBlur stdDeviation="3"/></filter>
             <mask id="m"><circle cx="60" cy="25" r="20" fill="white"/></mask>
             <g opacity="0.7"><circle cx="30" cy="25" r="15" filter="url(#f)"/></g>
             <rect x="40" width="50" height="50" fill="blue" mask="url(#m)"/>)svg"),
                                      "a");
  const cv::Mat whole = page->draw(400, {0, 0, 400, 200});
  const cv::Rect window(70, 30, 250, 120);
  cv::Mat difference;
  cv::absdiff(whole(window), page->draw(400, window), difference);
  double most = 0;
  cv::minMaxLoc(difference.reshape(1), nullptr, &most);
  EXPECT_LE(most, 2);
  EXPECT_GT(cv::mean(whole(window))[3], 50);
}

}  // namespace test_silhouette
}  // namespace tessera
