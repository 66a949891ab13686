// The background of pieces that were cut out of a photo.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "artwork/images/png_encoder.h"
#include "render/photo_ground.h"
#include "support/drawn_collage.h"
#include "support/input_error.h"
#include "support/sample_collage.h"

namespace tessera {
namespace test_photo_ground {

constexpr int kMargin_px = 24;
constexpr int kRim_px = 3;  // transparent, of a drawing

/// Grain, with the upper left pixel at `seed`.
cv::Mat photo_of(cv::Size size, std::uint64_t seed) {
  cv::Mat photo(size, CV_8UC4);
  cv::RNG random(seed);
  random.fill(photo, cv::RNG::UNIFORM, 40, 200);
  cv::Mat alpha(size, CV_8U, cv::Scalar(255));
  cv::insertChannel(alpha, photo, 3);
  return photo;
}

/// Squares of 40 px out of photos, on a canvas of 200 x 100 px; the picture has its size.
struct PhotoCollage : test::SampleCollage {
  PhotoCollage() {
    report.output.width_px = 200;
    report.output.background = kPhotoBackground;
    report.placements.clear();
    for (std::size_t slot : {std::size_t(0), std::size_t(1)}) {
      photos.push_back(photo_of({40 + 2 * kMargin_px, 40 + 2 * kMargin_px}, slot + 1));
      Shape& shape = report.shapes[slot];
      shape = test::make_test_shape("square", test::rectangle_outline(1, 1));
      set_photo(slot);
    }
  }

  /// Gives the shape the photo as its surroundings, and the middle of it as its drawing.
  void set_photo(std::size_t slot) {
    Shape& shape = report.shapes[slot];
    cv::Mat drawing = cv::Mat::zeros(40 + 2 * kRim_px, 40 + 2 * kRim_px, CV_8UC4);
    const cv::Rect square(kMargin_px, kMargin_px, 40, 40);
    photos[slot](square).copyTo(drawing(cv::Rect(kRim_px, kRim_px, 40, 40)));
    const std::vector<std::uint8_t> png = png_of(drawing);
    test::embed_artwork(shape, std::string(png.begin(), png.end()), float(drawing.cols), float(drawing.rows), 40);
    shape.artwork.surroundings_png = png_of(photos[slot]);
    shape.artwork.surroundings_margin_px = kMargin_px - kRim_px;
  }

  GroundTile ground(const GroundTile& below = {}) {
    test::DrawnCollage drawn(report);
    return photo_ground(report, below, drawn.drawers, drawn.stop);
  }

  std::vector<cv::Mat> photos;
};

double largest_difference(const cv::Mat& a, const cv::Mat& b) { return cv::norm(a, b, cv::NORM_INF); }

TEST(PhotoGround, IsThePhotoRoundAPieceThatLiesAsItLay) {
  PhotoCollage sample;
  sample.place(ShapeId{7}, 40, {100, 50}, 0);
  const cv::Mat page = sample.ground().page;
  ASSERT_EQ(page.size(), cv::Size(200, 100));
  const cv::Rect shown(100 - 20 - kMargin_px, 50 - 20 - kMargin_px, 40 + 2 * kMargin_px, 40 + 2 * kMargin_px);
  EXPECT_EQ(largest_difference(page(shown), sample.photos[0]), 0);
}

TEST(PhotoGround, ThePictureIsAsSharpAsThePhoto) {
  PhotoCollage sample;
  sample.place(ShapeId{7}, 40, {100, 50}, 0);
  sample.report.ground = sample.ground();
  cv::Mat photo;
  cv::cvtColor(sample.photos[0], photo, cv::COLOR_BGRA2BGR);
  const cv::Rect shown(100 - 20 - kMargin_px, 50 - 20 - kMargin_px, photo.cols, photo.rows);
  EXPECT_LE(largest_difference(test::drawn_picture(sample.report)(shown), photo), 1);
}

TEST(PhotoGround, EachPlaceShowsThePhotoOfTheNearestPiece) {
  PhotoCollage sample;
  sample.place(ShapeId{7}, 40, {60, 50}, 0);
  sample.place(ShapeId{3}, 40, {120, 50}, 0);  // the middle between them is at 90
  const cv::Mat page = sample.ground().page;
  const cv::Rect left(80, 40, 9, 20), right(91, 40, 9, 20);
  EXPECT_EQ(largest_difference(page(left), sample.photos[0](left - cv::Point(60 - 44, 50 - 44))), 0);
  EXPECT_EQ(largest_difference(page(right), sample.photos[1](right - cv::Point(120 - 44, 50 - 44))), 0);
}

TEST(PhotoGround, TheEdgeBetweenTwoPhotosIsSoft) {
  PhotoCollage sample;
  sample.place(ShapeId{7}, 40, {60, 50}, 0);
  sample.place(ShapeId{3}, 40, {120, 50}, 0);
  const cv::Mat page = sample.ground().page;
  const cv::Mat left = page(cv::Rect(89, 40, 1, 20)), right = page(cv::Rect(90, 40, 1, 20));
  const cv::Mat hard_left = sample.photos[0](cv::Rect(89 - 16, 34, 1, 20));
  const cv::Mat hard_right = sample.photos[1](cv::Rect(90 - 76, 34, 1, 20));
  EXPECT_LT(cv::norm(left, right, cv::NORM_L1), 0.7 * cv::norm(hard_left, hard_right, cv::NORM_L1));
}

TEST(PhotoGround, BetweenNeighboursOfOnePhotoIsThePhoto) {
  PhotoCollage sample;
  const cv::Mat photo = photo_of({138, 88}, 3);
  for (const int slot : {0, 1}) {
    sample.photos[std::size_t(slot)] = photo(cv::Rect(50 * slot, 0, 88, 88)).clone();
    sample.set_photo(std::size_t(slot));
  }
  sample.place(ShapeId{7}, 40, {60, 50}, 0);
  sample.place(ShapeId{3}, 40, {110, 50}, 0);
  EXPECT_EQ(largest_difference(sample.ground().page(cv::Rect(16, 6, 138, 88)), photo), 0);
}

TEST(PhotoGround, TakesTheNextPhotoWhereTheNearestShowsAnotherElement) {
  PhotoCollage sample;
  cv::Mat other = sample.photos[0](cv::Rect(kMargin_px + 40, 0, kMargin_px, 40 + 2 * kMargin_px));
  other.setTo(cv::Scalar::all(0));
  sample.set_photo(0);
  sample.place(ShapeId{7}, 40, {60, 50}, 0);
  sample.place(ShapeId{3}, 40, {110, 50}, 0);
  const cv::Mat page = sample.ground().page;
  const cv::Rect between(80, 40, 10, 20);
  EXPECT_EQ(largest_difference(page(between), sample.photos[1](between - cv::Point(110 - 44, 50 - 44))), 0);
}

/// One piece whose photo shows another element on the right of it, 1 px from it.
cv::Mat ground_beside_another_element(PhotoCollage& sample) {
  cv::Mat other = sample.photos[0](cv::Rect(kMargin_px + 41, 0, kMargin_px - 1, 40 + 2 * kMargin_px));
  cv::Mat alpha(other.size(), CV_8U, cv::Scalar(kOtherElementAlpha));
  cv::insertChannel(alpha, other, 3);
  sample.set_photo(0);
  sample.place(ShapeId{7}, 40, {60, 50}, 0);
  return sample.ground().page;
}

TEST(PhotoGround, ShowsAnotherElementWhereAGapIsWide) {
  PhotoCollage sample;
  const cv::Mat page = ground_beside_another_element(sample);
  cv::Mat shown = sample.photos[0](cv::Rect(kMargin_px + 44, 30, 10, 20)).clone();
  cv::insertChannel(cv::Mat(shown.size(), CV_8U, cv::Scalar(255)), shown, 3);
  EXPECT_LE(largest_difference(page(cv::Rect(84, 36, 10, 20)), shown), 1);
}

TEST(PhotoGround, KeepsAJointRoundPiecesInAWideGap) {
  PhotoCollage sample;
  const cv::Mat page = ground_beside_another_element(sample);
  const cv::Mat photo = sample.photos[0](cv::Rect(kMargin_px + 41, 30, 1, 20));
  cv::Mat other = photo.clone();
  cv::insertChannel(cv::Mat(photo.size(), CV_8U, cv::Scalar(255)), other, 3);
  EXPECT_GT(largest_difference(page(cv::Rect(81, 36, 1, 20)), other), 1);
}

TEST(PhotoGround, TurnsWithThePiece) {
  PhotoCollage sample;
  sample.place(ShapeId{7}, 40, {100, 50}, std::numbers::pi_v<float> / 2);
  cv::Mat turned;
  cv::rotate(sample.photos[0], turned, cv::ROTATE_90_CLOCKWISE);
  const cv::Rect shown(100 - 44, 50 - 44, 88, 88);
  EXPECT_LE(largest_difference(sample.ground().page(shown), turned), 3);
}

TEST(PhotoGround, RepeatsWithTheCanvas) {
  PhotoCollage sample;
  sample.canvas = make_seamless_canvas(200, 100, true, true);
  sample.place(ShapeId{7}, 40, {195, 50}, 0);
  const GroundTile tile = sample.ground();
  EXPECT_TRUE(tile.repeats);
  // The right part of the photo, from column 49 on, lies at the left end.
  EXPECT_EQ(largest_difference(tile.page(cv::Rect(0, 6, 39, 88)), sample.photos[0](cv::Rect(49, 0, 39, 88))), 0);
}

/// The ground is made in squares of 1024 px; they must not be seen. Moved by a part of the period, the same canvas is cut
/// into squares at other places.
TEST(PhotoGround, SquaresAgreeAtTheirEdges) {
  const auto ground_moved_by = [](Vec2 shift) {
    PhotoCollage sample;
    sample.canvas = make_seamless_canvas(200, 100, true, true);
    sample.report.output.width_px = 1600;
    for (const Vec2 centre : {Vec2{30, 30}, Vec2{95, 62}, Vec2{150, 20}, Vec2{180, 80}}) {
      const Vec2 at = sample.canvas.period.wrapped(centre + shift);
      sample.place(sample.report.placements.size() % 2 ? ShapeId{7} : ShapeId{3}, 40, at, 0);
    }
    return sample.ground().page;
  };
  const cv::Mat here = ground_moved_by({0, 0}), there = ground_moved_by({70, 40});
  cv::Mat tiles;
  cv::repeat(there, 2, 2, tiles);
  EXPECT_LE(largest_difference(here, tiles(cv::Rect(70 * 8, 40 * 8, 1600, 800))), 3);
}

TEST(PhotoGround, OfAnEnlargedPhotoIsItsPixelsAveraged) {
  PhotoCollage sample;
  sample.canvas = make_rectangle_canvas(120, 120);
  sample.report.output.width_px = 40;  // a third
  sample.place(ShapeId{7}, 40, {60, 60}, 0);
  cv::Mat photo = cv::Mat::zeros(120, 120, CV_8UC4), small;
  sample.photos[0].copyTo(photo(cv::Rect(16, 16, 88, 88)));
  cv::resize(photo, small, {40, 40}, 0, 0, cv::INTER_AREA);
  const cv::Rect whole(6, 6, 28, 28);  // px that the photo covers wholly
  cv::Mat page = sample.ground().page;
  ASSERT_EQ(page.size(), cv::Size(120, 120));  // averaged where it is drawn
  cv::resize(page, page, {40, 40}, 0, 0, cv::INTER_AREA);
  EXPECT_LE(largest_difference(page(whole), small(whole)), 1);
}

TEST(PhotoGround, FarFromAllPiecesShowsWhatIsBelowOrTheMeanColour) {
  PhotoCollage sample;
  sample.place(ShapeId{7}, 40, {50, 50}, 0);
  const cv::Vec4b mean = sample.ground().page.at<cv::Vec4b>(50, 190);
  EXPECT_EQ(mean[3], 255);
  EXPECT_NEAR(mean[0], 120, 8);
  GroundTile below;
  below.page = cv::Mat(10, 10, CV_8UC4, cv::Scalar(10, 20, 30, 255));
  below.size_px = {10, 10};
  EXPECT_EQ(sample.ground(below).page.at<cv::Vec4b>(50, 190), cv::Vec4b(10, 20, 30, 255));
}

TEST(PhotoGround, NeedsPiecesThatKnowTheirPhoto) {
  PhotoCollage sample;
  sample.place(ShapeId{7}, 40, {50, 50}, 0);
  sample.report.shapes[0].artwork.surroundings_png.clear();
  EXPECT_EQ(test::message_of([&] { sample.ground(); }).find("output.background: found \"photo\""), 0u);
}

TEST(PhotoGround, ADamagedPhotoShowsNothing) {
  PhotoCollage sample;
  sample.place(ShapeId{7}, 40, {50, 50}, 0);
  std::vector<std::uint8_t>& png = sample.report.shapes[0].artwork.surroundings_png;
  png.resize(png.size() / 2);
  GroundTile below;
  below.page = cv::Mat(10, 10, CV_8UC4, cv::Scalar(10, 20, 30, 255));
  below.size_px = {10, 10};
  EXPECT_EQ(sample.ground(below).page.at<cv::Vec4b>(50, 50), cv::Vec4b(10, 20, 30, 255));
  const cv::Mat alone = sample.ground().page;
  EXPECT_EQ(cv::countNonZero(alone.reshape(1)), 0) << "not black, where nothing lies below";
  sample.report.shapes[0].artwork.surroundings_margin_px = 100;  // more than the page holds
  EXPECT_NE(test::message_of([&] { sample.ground(below); }), "");
}

}  // namespace test_photo_ground
}  // namespace tessera
