// The elements made from a photograph and its labels.
#include <gtest/gtest.h>

#include <opencv2/imgproc.hpp>

#include "products/elements/elements_overview.h"
#include "products/elements/photo_elements.h"
#include "products/elements/segmentation/connected_labels.h"

namespace tessera {
namespace test_photo_elements {

constexpr int kDisc = 7, kSquare = 3, kCut = 5, kSpeck = 9;

/// Labels on 200 x 100 px. There are a disc of radius 25 with a hole, a square of 30 to its upper right, one cut by the edge, and a speck.
cv::Mat labels() {
  cv::Mat map = cv::Mat::zeros(100, 200, CV_32S);
  cv::circle(map, {60, 60}, 25, cv::Scalar(kDisc), cv::FILLED);
  cv::circle(map, {60, 60}, 5, cv::Scalar(0), cv::FILLED);
  map(cv::Rect(120, 20, 30, 30)) = kSquare;
  map(cv::Rect(180, 60, 20, 20)) = kCut;
  map(cv::Rect(100, 80, 3, 3)) = kSpeck;
  return map;
}

/// A photo that is red where elements are, and blue between them.
cv::Mat photo() {
  cv::Mat picture(100, 200, CV_8UC4, cv::Scalar(255, 0, 0, 255));
  picture.setTo(cv::Scalar(0, 0, 255, 255), labels() > 0);
  return picture;
}

std::vector<int> found_labels(const ElementSizes& sizes) {
  std::vector<int> result;
  for (const PhotoElement& element : find_elements(LabelRuns(labels()), sizes).elements)
    result.push_back(element.label);
  return result;
}

PhotoElement element_of(int label) {
  for (const PhotoElement& element : find_elements(LabelRuns(labels()), {}).elements)
    if (element.label == label) return element;
  throw std::logic_error("no such element");
}

TEST(PhotoElements, ComeInTheOrderOfTheirPlaces) {
  EXPECT_EQ(found_labels({}), (std::vector<int>{kSquare, kDisc, kSpeck}));
  EXPECT_EQ(element_of(kSquare).box, cv::Rect(120, 20, 30, 30));
  EXPECT_EQ(element_of(kSquare).area_px2, 900);
}

TEST(PhotoElements, ThoseThatTheEdgeCutsAreLeftOut) {
  const FoundElements found = find_elements(LabelRuns(labels()), {});
  EXPECT_EQ(found.at_edge, 1u);
  EXPECT_EQ(found.too_small + found.too_large, 0u);
  for (const cv::Rect& at_edge : {cv::Rect(0, 40, 9, 9), cv::Rect(50, 0, 9, 9), cv::Rect(50, 91, 9, 9)}) {
    cv::Mat map = cv::Mat::zeros(100, 200, CV_32S);
    map(at_edge) = 1;
    EXPECT_EQ(find_elements(LabelRuns(map), {}).at_edge, 1u);
  }
}

TEST(PhotoElements, SizesAreSquareRootsOfAreas) {
  EXPECT_EQ(found_labels({.least_px = 30}), (std::vector<int>{kSquare, kDisc}));
  EXPECT_EQ(found_labels({.least_px = 30.1}), std::vector<int>{kDisc});
  EXPECT_EQ(found_labels({.most_px = 30}), (std::vector<int>{kSquare, kSpeck}));
  EXPECT_EQ(find_elements(LabelRuns(labels()), {.least_px = 10, .most_px = 40}).too_small, 1u);
  EXPECT_EQ(find_elements(LabelRuns(labels()), {.least_px = 10, .most_px = 40}).too_large, 1u);
}

TEST(PhotoElements, OfAnEmptyMapThereAreNone) {
  EXPECT_TRUE(find_elements(LabelRuns(cv::Mat()), {}).elements.empty());
  EXPECT_TRUE(find_elements(LabelRuns(cv::Mat::zeros(3, 3, CV_32S)), {}).elements.empty());
}

TEST(PhotoElements, AreCutOutWithAnEdgeThatLiesWhereItLay) {
  const cv::Mat cut = cut_element(photo(), LabelRuns(labels()), element_of(kSquare));
  ASSERT_EQ(cut.size(), cv::Size(36, 36));
  double opacity = 0;
  for (int x = 0; x < cut.cols; ++x) opacity += cut.at<cv::Vec4b>(18, x)[3] / 255.0;
  EXPECT_NEAR(opacity, 30, 0.1);
  EXPECT_EQ(cut.at<cv::Vec4b>(18, 18)[3], 255);
  EXPECT_EQ(cut.at<cv::Vec4b>(18, 0)[3], 0);
  EXPECT_LT(cut.at<cv::Vec4b>(18, 2)[3], 127);
  EXPECT_GT(cut.at<cv::Vec4b>(18, 3)[3], 127);
}

TEST(PhotoElements, NoGapShinesThroughTheEdge) {
  const cv::Mat cut = cut_element(photo(), LabelRuns(labels()), element_of(kDisc));
  for (int y = 0; y < cut.rows; ++y)
    for (int x = 0; x < cut.cols; ++x) {
      const cv::Vec4b pixel = cut.at<cv::Vec4b>(y, x);
      const bool is_hole = cv::norm(cv::Point(x, y) - cv::Point(cut.cols / 2, cut.rows / 2)) < 8;
      if (pixel[3] > 8 && !is_hole) {
        ASSERT_LT(pixel[0], 40) << x << ", " << y;
      }
    }
}

TEST(PhotoElements, HolesAreFilled) {
  const cv::Mat cut = cut_element(photo(), LabelRuns(labels()), element_of(kDisc));
  EXPECT_EQ(cut.at<cv::Vec4b>(cut.rows / 2, cut.cols / 2)[3], 255);
}

/// An element 1 px from the photo's edge still has its whole rim.
TEST(PhotoElements, TheRimIsWholeNearTheEdge) {
  cv::Mat map = cv::Mat::zeros(40, 40, CV_32S);
  map(cv::Rect(1, 1, 20, 20)) = 1;
  const cv::Mat cut =
      cut_element(cv::Mat(40, 40, CV_8UC4, cv::Scalar(0, 0, 255, 255)), LabelRuns(map), {1, {1, 1, 20, 20}, 400});
  ASSERT_EQ(cut.size(), cv::Size(26, 26));
  EXPECT_EQ(cut.at<cv::Vec4b>(0, 13)[3], 0);
  EXPECT_EQ(cut.at<cv::Vec4b>(13, 13)[3], 255);
}

TEST(PhotoElements, ThoseOfMoreThan16MegapixelsAreLeftOut) {
  const auto found = [](int width, int height) {
    std::vector<LabelRun> runs;
    for (int y = 0; y < height; ++y) runs.push_back({1, y + 1, width});
    return find_elements(LabelRuns({width + 2, height + 2}, {{}, runs}), {});
  };
  EXPECT_EQ(found(4000, 4000).elements.size(), 1u);
  EXPECT_EQ(found(4000, 4000).too_many_pixels, 0u);
  EXPECT_TRUE(found(4000, 4001).elements.empty());
  EXPECT_EQ(found(4000, 4001).too_many_pixels, 1u);
}

/// The colours are computed in strips, which lie elsewhere in the turned photo.
TEST(PhotoElements, ALargeOneHasNoSeams) {
  cv::Mat picture(1300, 1100, CV_8UC4), map = cv::Mat::zeros(1300, 1100, CV_32S);
  cv::randu(picture, 0, 256);
  for (int y = 20; y < 1280; y += 8) map(cv::Rect(20 + y / 8 % 5, y, 1000, 5)) = 1;  // makes teeth
  map(cv::Rect(20, 20, 200, 1260)) = 1;
  const auto cut_out = [](const cv::Mat& photo, const cv::Mat& labels) {
    const LabelRuns runs(labels);
    return cut_element(photo, runs, find_elements(runs, {}).elements.at(0));
  };
  const cv::Mat upright = cut_out(picture, map);
  EXPECT_LE(cv::norm(upright, cut_out(picture.t(), map.t()).t(), cv::NORM_INF), 1);
}

cv::Mat two_stripes() {
  cv::Mat map = cv::Mat::zeros(40, 60, CV_32S);
  map(cv::Rect(2, 2, 20, 30)) = 5;
  map(cv::Rect(30, 2, 20, 30)) = 5;
  return map;
}

TEST(ConnectedLabels, ANumberInTwoPlacesMakesTwoElements) {
  const cv::Mat labels = connected_labels(two_stripes());
  EXPECT_EQ(labels.at<int>(10, 10), 1);
  EXPECT_EQ(labels.at<int>(10, 40), 2);
  EXPECT_EQ(cv::countNonZero(labels), 2 * 20 * 30);
}

TEST(ConnectedLabels, NumbersThatTouchStayApart) {
  cv::Mat map = two_stripes();
  map(cv::Rect(22, 2, 8, 30)) = 6;
  const cv::Mat labels = connected_labels(map);
  EXPECT_EQ(labels.at<int>(10, 25), 2);
  EXPECT_EQ(labels.at<int>(10, 40), 3);
}

/// Each of these scattered numbers covers a box as large as the photo, which must not take time.
TEST(ConnectedLabels, ScatteredNumbersAreNothing) {
  cv::Mat map(1000, 1000, CV_32S);
  cv::RNG rng(7);
  rng.fill(map, cv::RNG::UNIFORM, -3, 20000);
  EXPECT_EQ(cv::countNonZero(connected_labels(map)), 0);
}

TEST(ConnectedLabels, SpecksAreGap) {
  cv::Mat map = cv::Mat::zeros(40, 60, CV_32S);
  map(cv::Rect(2, 2, 8, 8)) = 1;
  map(cv::Rect(20, 2, 7, 9)) = 2;
  EXPECT_EQ(cv::countNonZero(connected_labels(map)), 64);
  EXPECT_TRUE(connected_labels(cv::Mat()).empty());
}

TEST(ElementsOverview, ShowsOutlinesAndKeepsTheSize) {
  const FoundElements found = find_elements(LabelRuns(labels()), {});
  const cv::Mat with = elements_overview(photo(), LabelRuns(labels()), found.elements);
  const cv::Mat without = elements_overview(photo(), LabelRuns(labels()), {});
  ASSERT_EQ(with.size(), photo().size());
  ASSERT_EQ(with.type(), CV_8UC3);
  EXPECT_NE(with.at<cv::Vec3b>(35, 120), without.at<cv::Vec3b>(35, 120)) << "the square's left side";
  EXPECT_EQ(with.at<cv::Vec3b>(10, 60), without.at<cv::Vec3b>(10, 60)) << "a gap";
}

}  // namespace test_photo_elements
}  // namespace tessera
