// The parts of an image that differ in colour.
#include <gtest/gtest.h>

#include <opencv2/core/utility.hpp>
#include <opencv2/imgproc.hpp>
#include <set>

#include "products/mosaic/segmentation.h"
#include "products/mosaic/size_map.h"

namespace tessera {
namespace test_segmentation {

const cv::Scalar kBlue(200, 60, 30), kYellow(40, 210, 240), kRed(40, 30, 210);

/// A yellow disc in the middle of a blue image.
cv::Mat disc(int radius_px) {
  cv::Mat image(300, 400, CV_8UC3, kBlue);
  cv::circle(image, {200, 150}, radius_px, kYellow, cv::FILLED);
  return image;
}

cv::Mat noise(cv::Size size) {
  cv::Mat image(size, CV_8UC3);
  cv::RNG random(3);
  random.fill(image, cv::RNG::UNIFORM, 0, 256);
  return image;
}

bool same(const cv::Mat& one, const cv::Mat& other) {
  return one.size() == other.size() && cv::norm(one, other, cv::NORM_INF) == 0;
}

int smallest_part(const Segmentation& found) {
  int least = int(found.labels.total());
  for (int label = 0; label < int(found.colours.size()); ++label) {
    cv::Mat parts, statistics, centres;
    const int n = cv::connectedComponentsWithStats(found.labels == label, parts, statistics, centres, 4, CV_32S);
    for (int i = 1; i < n; ++i) least = std::min(least, statistics.at<int>(i, cv::CC_STAT_AREA));
  }
  return least;
}

double distance(const cv::Vec3b& bgr, const cv::Scalar& colour) {
  return cv::norm(cv::Vec3d(bgr) - cv::Vec3d(colour[0], colour[1], colour[2]), cv::NORM_INF);
}

TEST(Segmentation, FindsADiscAndItsColour) {
  const cv::Mat image = disc(80);
  const MosaicPlan plan = mosaic_plan(image.size(), 1000);
  const Segmentation found = segmentation(image, plan, 2);
  ASSERT_EQ(found.labels.size(), size_map_size(plan));
  ASSERT_EQ(found.colours.size(), 2u);
  const int outside = found.labels.at<std::uint8_t>(0, 0), inside = 1 - outside;
  EXPECT_EQ(found.labels.at<std::uint8_t>(found.labels.rows / 2, found.labels.cols / 2), inside);
  EXPECT_LE(distance(found.colours[std::size_t(outside)], kBlue), 8);
  EXPECT_LE(distance(found.colours[std::size_t(inside)], kYellow), 8);
  EXPECT_NEAR(cv::countNonZero(found.labels == inside) / double(found.labels.total()), CV_PI * 80 * 80 / (300 * 400),
              0.01);
}

TEST(Segmentation, HasNoPartThatIsTooSmallForPieces) {
  cv::Mat image = disc(80);
  cv::circle(image, {40, 40}, 9, kYellow, cv::FILLED);  // 14 cells across, about 150 cells in area
  cv::circle(image, {200, 150}, 9, kBlue, cv::FILLED);
  const MosaicPlan plan = mosaic_plan(image.size(), 1000);
  const Segmentation found = segmentation(image, plan, 2);
  EXPECT_EQ(cv::countNonZero(found.labels != found.labels.at<std::uint8_t>(0, 0)),
            cv::countNonZero(segmentation(disc(80), plan, 2).labels != found.labels.at<std::uint8_t>(0, 0)));
  const double least_cells = 16 * plan.min_scale_px * plan.min_scale_px / (kSizeMapPixel_px * kSizeMapPixel_px);
  for (const int side : {7, 60, 300}) {
    const Segmentation noisy = segmentation(noise({side, side}), plan, 8);
    EXPECT_TRUE(noisy.colours.size() == 1 || smallest_part(noisy) >= least_cells) << side;
  }
}

TEST(Segmentation, AFlatImageIsOneRegion) {
  const cv::Mat flat(20, 30, CV_8UC3, kRed);
  EXPECT_EQ(segmentation(flat, mosaic_plan(flat.size(), 200), 8).colours.size(), 1u);
  const cv::Mat pixel(1, 1, CV_8UC3, kRed);
  EXPECT_EQ(segmentation(pixel, mosaic_plan(pixel.size(), 200), 8).colours.size(), 1u);
}

TEST(Segmentation, ColoursThatHardlyDifferAreOne) {
  cv::Mat image = disc(80);
  image.rowRange(0, 150) += cv::Scalar(6, 6, 6);
  EXPECT_EQ(segmentation(image, mosaic_plan(image.size(), 1000), 8).colours.size(), 2u);
}

TEST(Segmentation, IsTheSameWhateverTheThreads) {
  const cv::Mat image = noise({40, 30});
  const MosaicPlan plan = mosaic_plan(image.size(), 1000);
  const int threads = cv::getNumThreads();
  cv::setNumThreads(1);
  const Segmentation one = segmentation(image, plan, 6);
  cv::setNumThreads(4);
  cv::theRNG().state = 77;
  const Segmentation four = segmentation(image, plan, 6);
  cv::setNumThreads(threads);
  EXPECT_TRUE(same(one.labels, four.labels));
  EXPECT_EQ(one.colours, four.colours);
  EXPECT_TRUE(same(region_picture(one, plan), region_picture(four, plan)));
}

TEST(RegionPicture, HasTwiceTheCanvasAndNoMixedColours) {
  const cv::Mat image = disc(80);
  const MosaicPlan plan = mosaic_plan(image.size(), 300);
  const Segmentation found = segmentation(image, plan, 2);
  const cv::Mat picture = region_picture(found, plan);
  EXPECT_EQ(picture.size(), plan.canvas_px * 2);
  std::set<std::array<int, 3>> colours;
  for (int y = 0; y < picture.rows; ++y) {
    for (int x = 0; x < picture.cols; ++x) {
      const cv::Vec4b p = picture.at<cv::Vec4b>(y, x);
      colours.insert({p[0], p[1], p[2]});
    }
  }
  EXPECT_EQ(colours.size(), 2u);
}

TEST(RegionPicture, OfTheLargestMosaicIsOneThatACanvasMayBe) {
  for (const cv::Size size : {cv::Size(8, 1), cv::Size(1, 1)}) {
    const MosaicPlan plan = mosaic_plan(size, kMostMosaicPieces);
    cv::Mat image(size * 10, CV_8UC3, kBlue);
    image.colRange(0, image.cols / 2) = kRed;
    const cv::Mat picture = region_picture(segmentation(image, plan, 2), plan);
    EXPECT_LE(std::max(picture.cols, picture.rows), 8192);
    EXPECT_LE(picture.total(), 50'000'000u);
    EXPECT_NEAR(picture.cols / double(picture.rows), plan.canvas_px.width / double(plan.canvas_px.height), 0.01);
  }
}

}  // namespace test_segmentation
}  // namespace tessera
