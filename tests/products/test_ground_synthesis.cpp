// The ground between elements: the pixels of a photo that show it, and the picture made from them.
#include <gtest/gtest.h>

#include <opencv2/imgproc.hpp>

#include "drawn_elements.h"
#include "products/elements/ground_pixels.h"
#include "products/elements/ground_synthesis.h"

namespace tessera {
namespace test_ground_synthesis {

const cv::Scalar kStone(160, 150, 140), kMortar(50, 70, 90);

struct Wall {
  explicit Wall(const cv::Mat& truth) : photo(test::photographed(truth, kStone, kMortar)) {}
  cv::Mat ground() const { return ground_pixels(photo.bgr, LabelRuns(photo.truth)).certain; }
  cv::Mat picture(int side_px) const { return synthesised_ground(photo.bgr, ground(), side_px); }

  test::ElementPhoto photo;
};

TEST(GroundPixels, AreNoneOfTheElementsNorOfTheirSoftEdge) {
  const Wall wall(test::cobbles());
  const cv::Mat ground = wall.ground();
  cv::Mat element;
  cv::dilate(wall.photo.truth > 0, element, cv::Mat::ones(3, 3, CV_8U));
  EXPECT_EQ(cv::countNonZero(ground & element), 0);
  EXPECT_GT(cv::countNonZero(ground), 0.2 * cv::countNonZero(wall.photo.truth == 0));
}

TEST(GroundPixels, AreThePartOfThePhotoThatElementsDoNotCover) {
  for (const cv::Mat& truth : {test::cobbles(), test::discs(), test::bricks()}) {
    const Wall wall(truth);
    const double gaps = double(cv::countNonZero(truth == 0)) / double(truth.total());
    EXPECT_NEAR(ground_pixels(wall.photo.bgr, LabelRuns(truth)).part, gaps, 0.08) << "with strong texture and noise";
  }
}

/// Two stones have no labels, as if the search had missed them.
TEST(GroundPixels, AreNoneOfElementsThatWereNotFound) {
  Wall wall(test::cobbles());
  const cv::Mat missed = (wall.photo.truth == 17) | (wall.photo.truth == 25);
  wall.photo.truth.setTo(0, missed);
  const cv::Mat ground = wall.ground();
  EXPECT_LT(cv::countNonZero(ground & missed), 0.03 * cv::countNonZero(missed));
  EXPECT_GT(cv::countNonZero(ground), 0.2 * cv::countNonZero((wall.photo.truth == 0) & ~missed));
}

TEST(GroundPixels, AreNoneWithoutGapsOrWithoutElements) {
  const cv::Mat photo = test::photographed(test::bricks(), kStone, kMortar).bgr;
  EXPECT_EQ(cv::countNonZero(ground_pixels(photo, LabelRuns(cv::Mat::ones(photo.size(), CV_32S))).certain), 0);
  EXPECT_EQ(cv::countNonZero(ground_pixels(photo, LabelRuns(cv::Mat::zeros(photo.size(), CV_32S))).certain), 0);
}

/// The mean of the absolute differences of two columns.
double step_between(const cv::Mat& picture, int left, int right) {
  cv::Mat difference;
  cv::absdiff(picture.col(left), picture.col(right), difference);
  const cv::Scalar mean = cv::mean(difference);
  return (mean[0] + mean[1] + mean[2]) / 3;
}

TEST(GroundSynthesis, IsMadeOfTheGroundAlone) {
  const Wall wall(test::discs());
  const cv::Mat picture = wall.picture(200);
  ASSERT_EQ(picture.size(), cv::Size(200, 200));
  ASSERT_EQ(picture.type(), CV_8UC3);
  cv::Scalar mean, deviation, mean_there, deviation_there;
  cv::meanStdDev(picture, mean, deviation);
  cv::meanStdDev(wall.photo.bgr, mean_there, deviation_there, wall.ground());
  for (int c = 0; c < 3; ++c) {
    EXPECT_NEAR(mean[c], mean_there[c], 3) << c;
    EXPECT_GT(deviation[c], 0.5 * deviation_there[c]) << "as rough as the ground";
    EXPECT_LT(deviation[c], 1.1 * deviation_there[c]);
  }
}

/// The photo is 20 levels brighter at its right. The ground made from it is even, because a step in the light would show.
TEST(GroundSynthesis, HasTheSameLightEverywhere) {
  const Wall wall(test::discs());
  const cv::Mat picture = wall.picture(256);
  std::vector<double> bright;
  for (int y = 0; y < 256; y += 64) {
    for (int x = 0; x < 256; x += 64) bright.push_back(cv::mean(picture(cv::Rect(x, y, 64, 64)))[1]);
  }
  const auto [least, most] = std::minmax_element(bright.begin(), bright.end());
  EXPECT_LT(*most - *least, 8);
}

TEST(GroundSynthesis, HasNoSeamAcrossItsEdges) {
  for (const cv::Mat& truth : {test::discs(), test::cobbles()}) {
    const cv::Mat picture = Wall(truth).picture(150);
    const cv::Mat turned = picture.t();
    for (const cv::Mat& way : {picture, turned}) {
      double inside = 0;
      for (int x = 20; x < 120; ++x) inside += step_between(way, x, x + 1) / 100;
      EXPECT_LT(step_between(way, 149, 0), 1.5 * inside);
      EXPECT_GT(inside, 1) << "else there is nothing to see";
    }
  }
}

TEST(GroundSynthesis, OfOnePhotoIsOnePicture) {
  const Wall wall(test::cobbles());
  EXPECT_EQ(cv::norm(wall.picture(100), wall.picture(100), cv::NORM_INF), 0);
}

TEST(GroundSynthesis, NeedsSomePlacesOfTheSmallestPatch) {
  cv::Mat ground = cv::Mat::zeros(100, 300, CV_8U);
  const cv::Mat photo(ground.size(), CV_8UC3, cv::Scalar(1, 2, 3));
  EXPECT_EQ(patch_side_px(ground), 0);
  EXPECT_TRUE(synthesised_ground(photo, ground, 64).empty());
  for (int i = 0; i < kLeastPlaces - 1; ++i) ground(cv::Rect(20 * i, 10, kLeastPatch_px, kLeastPatch_px)).setTo(255);
  EXPECT_EQ(patch_side_px(ground), 0);
  ground(cv::Rect(20 * (kLeastPlaces - 1), 10, kLeastPatch_px, kLeastPatch_px)).setTo(255);
  EXPECT_EQ(patch_side_px(ground), kLeastPatch_px);
  const cv::Mat picture = synthesised_ground(photo, ground, 64);
  EXPECT_EQ(cv::norm(picture, cv::Mat(picture.size(), CV_8UC3, cv::Scalar(1, 2, 3)), cv::NORM_INF), 0);
}

TEST(GroundSynthesis, TakesPatchesAsLargeAsThereAreEnoughOf) {
  EXPECT_EQ(patch_side_px(cv::Mat(600, 600, CV_8U, cv::Scalar(255))), 64);
  EXPECT_EQ(patch_side_px(cv::Mat(60, 600, CV_8U, cv::Scalar(255))), 24) << "48 places and more, not 12";
}

}  // namespace test_ground_synthesis
}  // namespace tessera
