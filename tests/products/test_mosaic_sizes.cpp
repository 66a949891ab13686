// The sizes of a mosaic's pieces by place.
#include <gtest/gtest.h>

#include <cmath>
#include <opencv2/imgproc.hpp>

#include "core/base/error.h"
#include "products/mosaic/mosaic_plan.h"
#include "products/mosaic/size_gradation.h"
#include "products/mosaic/size_map.h"

namespace tessera {
namespace test_mosaic_sizes {

const cv::Scalar kGrey(128, 128, 128);

/// A grey picture whose left half has stripes of width `stripe_px`.
cv::Mat half_striped(cv::Size size, int stripe_px) {
  cv::Mat image(size, CV_8UC3, kGrey);
  for (int x = 0; x < size.width / 2; x += 2 * stripe_px)
    image.colRange(x, std::min(x + stripe_px, size.width / 2)) = cv::Scalar(20, 30, 200);
  return image;
}

double expected_pieces(const cv::Mat& map, const MosaicPlan& plan) {
  double sum = 0;
  for (int y = 0; y < map.rows; ++y) {
    for (int x = 0; x < map.cols; ++x) {
      const double white = map.at<std::uint8_t>(y, x) / 255.;
      sum += mosaic_pieces_per_px2(plan.min_scale_px, plan.min_scale_px * std::pow(plan.max_scale_px / plan.min_scale_px, white));
    }
  }
  return sum / double(map.total()) * plan.canvas_px.area();
}

cv::Mat map_by_contrast(const cv::Mat& image, const MosaicPlan& plan) {
  return size_map(image, plan, cv::Mat::zeros(size_map_size(plan), CV_32F));
}

bool same(const cv::Mat& one, const cv::Mat& other) {
  return one.size() == other.size() && cv::norm(one, other, cv::NORM_INF) == 0;
}

TEST(MosaicPlan, HasTheImagesAspectAndRoomForThePieces) {
  const MosaicPlan plan = mosaic_plan({451, 300}, 3000);
  EXPECT_NEAR(plan.canvas_px.width / double(plan.canvas_px.height), 451 / 300., 1e-3);
  EXPECT_NEAR(plan.canvas_px.area() * 0.88 / 3000, 22 * 22, 1);  // the area of a piece of the mean size
  EXPECT_EQ(plan.min_scale_px, 16);
  EXPECT_EQ(plan.max_scale_px, 80);
}

TEST(MosaicVariety, IsNoneWhereDrawingsAreFew) {
  const MosaicPlan plan = mosaic_plan({300, 200}, 500);
  for (const std::size_t shapes : {1, 99}) {
    EXPECT_EQ(mosaic_variety(plan, shapes).apart_px, 0) << shapes;
    EXPECT_EQ(mosaic_variety(plan, shapes).repetition_exponent, 0) << shapes;
  }
  EXPECT_EQ(mosaic_variety(plan, 100).apart_px, plan.min_scale_px / 2);
  EXPECT_GT(mosaic_variety(plan, 100).repetition_exponent, 0);
}

TEST(MosaicPlan, TheLargestIsACanvasThatAJobMayHave) {
  for (const cv::Size image : {cv::Size(8000, 1000), cv::Size(1000, 8000), cv::Size(1, 1)}) {
    const MosaicPlan plan = mosaic_plan(image, kMostMosaicPieces);
    EXPECT_LE(std::max(plan.canvas_px.width, plan.canvas_px.height), 20'000);
    EXPECT_LE(double(plan.canvas_px.width) * plan.canvas_px.height, 100e6);
    EXPECT_GT(std::min(plan.canvas_px.width, plan.canvas_px.height), plan.max_scale_px);
  }
}

TEST(MosaicPlan, RefusesWhatIsTooFewTooManyOrTooLong) {
  EXPECT_THROW(mosaic_plan({100, 100}, kFewestMosaicPieces - 1), InputError);
  EXPECT_THROW(mosaic_plan({100, 100}, kMostMosaicPieces + 1), InputError);
  EXPECT_THROW(mosaic_plan({801, 100}, 3000), InputError);
  EXPECT_THROW(mosaic_plan({100, 801}, 3000), InputError);
  EXPECT_NO_THROW(mosaic_plan({800, 100}, kFewestMosaicPieces));
}

// The numbers of pieces per million px² for places with this largest size. They were measured in mosaics of 3,041 shapes (six of about
// 1,000 pieces, two of 2,000).
TEST(MosaicPlan, ExpectsAsManyPiecesAsCameInMeasurements) {
  const MosaicPlan plan = mosaic_plan({100, 100}, 3000);
  const std::pair<double, double> kMeasured[] = {{16, 3242}, {32.4, 2195}, {37.9, 1906}, {44.4, 1801}, {52.3, 1719}};
  for (const auto& [largest_px, measured] : kMeasured)
    EXPECT_NEAR(mosaic_pieces_per_px2(plan.min_scale_px, largest_px) * 1e6 / measured, 1, 0.05) << largest_px;
}

TEST(LimitGrowth, MakesAConeRoundWhatIsSmall) {
  cv::Mat sizes(41, 61, CV_32F, cv::Scalar(100));
  sizes.at<float>(20, 30) = 10;
  limit_growth(sizes, 2);
  for (int y = 0; y < sizes.rows; ++y) {
    for (int x = 0; x < sizes.cols; ++x) {
      const double away_px = std::hypot(x - 30, y - 20);
      EXPECT_NEAR(sizes.at<float>(y, x), std::min(100., 10 + 2 * away_px), 0.09 * 2 * away_px + 1e-3) << x << " " << y;
    }
  }
}

TEST(LimitGrowth, LeavesWhatIsGentle) {
  cv::Mat sizes(20, 30, CV_32F);
  for (int y = 0; y < sizes.rows; ++y) {
    for (int x = 0; x < sizes.cols; ++x) sizes.at<float>(y, x) = float(50 + x - y);
  }
  cv::Mat limited = sizes.clone();
  limit_growth(limited, 1.5f);
  EXPECT_TRUE(same(limited, sizes));
}

TEST(SizeMap, IsUniformForAFlatImage) {
  const MosaicPlan plan = mosaic_plan({300, 200}, 3000);
  const cv::Mat map = map_by_contrast(cv::Mat(200, 300, CV_8UC3, kGrey), plan);
  EXPECT_EQ(map.type(), CV_8UC1);
  EXPECT_EQ(map.size(), cv::Size((plan.canvas_px.width + 2) / 4, (plan.canvas_px.height + 2) / 4));
  EXPECT_EQ(cv::norm(map, cv::NORM_INF), map.at<std::uint8_t>(0, 0));
  EXPECT_NEAR(expected_pieces(map, plan), 3000, 30);
}

TEST(SizeMap, IsSmallOnDetailAndLargeOnFlatParts) {
  const MosaicPlan plan = mosaic_plan({600, 400}, 3000);
  const cv::Mat map = map_by_contrast(half_striped({600, 400}, 20), plan);
  const int quarter = map.cols / 4;
  const double detail = cv::mean(map.colRange(0, quarter))[0];
  const double flat = cv::mean(map.colRange(3 * quarter, map.cols))[0];
  EXPECT_LT(detail, 140);  // 34 px
  EXPECT_GT(flat, 170);    // 40 px
}

TEST(SizeMap, GivesAboutAsManyPiecesAsAreWishedFor) {
  for (const int pieces : {kFewestMosaicPieces, 3000}) {
    for (const int stripe_px : {10, 60, 300}) {
      const MosaicPlan plan = mosaic_plan({600, 400}, pieces);
      EXPECT_NEAR(expected_pieces(map_by_contrast(half_striped({600, 400}, stripe_px), plan), plan) / pieces, 1, 0.01)
          << pieces << " " << stripe_px;
    }
  }
}

// Texture that no piece can show must not cost pieces.
TEST(SizeMap, PassesOverTextureThatIsFinerThanThePieces) {
  const cv::Size size(3600, 2400);
  const MosaicPlan plan = mosaic_plan(size, 3000);
  const cv::Mat map = map_by_contrast(half_striped(size, 1), plan);
  const int quarter = map.cols / 4;
  EXPECT_NEAR(cv::mean(map.colRange(0, quarter))[0], cv::mean(map.colRange(3 * quarter, map.cols))[0], 4);
}

TEST(SizeMap, IsTheSameOnAnyNumberOfThreads) {
  const MosaicPlan plan = mosaic_plan({600, 400}, 3000);
  const cv::Mat image = half_striped({600, 400}, 15);
  const int threads = cv::getNumThreads();
  const cv::Mat map = map_by_contrast(image, plan);
  cv::setNumThreads(1);
  EXPECT_TRUE(same(map_by_contrast(image, plan), map));
  cv::setNumThreads(threads);
}

TEST(SizeMap, OfASinglePixelAndOfTheLargestImage) {
  const MosaicPlan dot = mosaic_plan({1, 1}, kFewestMosaicPieces);
  EXPECT_NEAR(expected_pieces(map_by_contrast(cv::Mat(1, 1, CV_8UC3, kGrey), dot), dot), 100, 1);
  const cv::Size largest(20'000, 2'500);
  const MosaicPlan plan = mosaic_plan(largest, 1000);
  const cv::Mat map = map_by_contrast(half_striped(largest, 500), plan);
  EXPECT_EQ(map.size(), cv::Size((plan.canvas_px.width + 2) / 4, (plan.canvas_px.height + 2) / 4));
}

TEST(SizeMap, IsSmallWhereEyesLookAndLargerElsewhere) {
  const MosaicPlan plan = mosaic_plan({600, 400}, 3000);
  const cv::Mat image = half_striped({600, 400}, 20);
  cv::Mat saliency = cv::Mat::zeros(size_map_size(plan), CV_32F);
  const cv::Rect spot(saliency.cols * 3 / 4, saliency.rows / 2, saliency.cols / 10, saliency.rows / 10);
  saliency(spot) = 1;
  const cv::Mat map = size_map(image, plan, saliency), before = map_by_contrast(image, plan);
  EXPECT_GT(cv::mean(before(spot))[0], 170);  // a flat area
  EXPECT_LT(cv::mean(map(spot))[0], 20);
  const int quarter = map.cols / 4;
  EXPECT_GT(cv::mean(map.colRange(0, quarter))[0], cv::mean(before.colRange(0, quarter))[0]);
  EXPECT_NEAR(expected_pieces(map, plan) / 3000, 1, 0.01);
}

// If everything is painted as salient, nothing is. The number of pieces stays the wished one.
TEST(SizeMap, IsTheSameWhereAllIsEquallySalient) {
  const MosaicPlan plan = mosaic_plan({600, 400}, 3000);
  const cv::Mat image = half_striped({600, 400}, 20);
  const cv::Mat everywhere(size_map_size(plan), CV_32F, cv::Scalar(1));
  EXPECT_LE(cv::norm(size_map(image, plan, everywhere), map_by_contrast(image, plan), cv::NORM_INF), 1);
}

TEST(SalientDetail, TakesPiecesFromTheLargestToTheSmallest) {
  const MosaicPlan plan = mosaic_plan({200, 100}, 3000);
  const cv::Mat detail(100, 200, CV_32F, cv::Scalar(2));
  cv::Mat saliency(100, 200, CV_32F, cv::Scalar(0));
  saliency.colRange(100, 150) = 1. / 3;
  saliency.colRange(150, 200) = 1;
  const cv::Mat salient = salient_detail(detail, saliency, plan);
  EXPECT_FLOAT_EQ(salient.at<float>(50, 0), 2);
  EXPECT_NEAR(salient.at<float>(50, 120), 2 * 5,
              1e-4);  // sizes follow the cube root: from 80 to 16 px is a factor of 5
  EXPECT_NEAR(salient.at<float>(50, 199), 2 * 125, 1e-3);
}

TEST(LargestSizes, HalveWhereTheDetailIsEightTimesAsMuch) {
  const MosaicPlan plan = mosaic_plan({200, 100}, 3000);
  cv::Mat detail(100, 200, CV_32F, cv::Scalar(8));
  detail.colRange(100, 200) = 1;
  const cv::Mat sizes = largest_sizes(detail, plan);
  EXPECT_NEAR(sizes.at<float>(50, 199) / sizes.at<float>(50, 0), 2, 0.01);
}

TEST(LargestSizes, GrowByAPxForAPxOfTheCanvas) {
  const MosaicPlan plan = mosaic_plan({200, 100}, 3000);
  cv::Mat detail(100, 200, CV_32F, cv::Scalar(100));
  detail.colRange(100, 200) = 0.5;
  const cv::Mat sizes = largest_sizes(detail, plan);
  EXPECT_NEAR(sizes.at<float>(50, 103) - sizes.at<float>(50, 99), 4 * kSizeMapPixel_px, 0.01);
}

}  // namespace test_mosaic_sizes
}  // namespace tessera
