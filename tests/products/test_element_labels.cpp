// Photos with known elements: all elements are found, nothing else is, and the labels are as the header says.
#include "products/elements/element_labels.h"

#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>

#include "drawn_elements.h"
#include "products/elements/photo_elements.h"

namespace tessera {
namespace test_element_labels {

using test::ElementPhoto;
using test::photographed;

struct Score {
  int whole = 0;      // elements of the truth that do not touch the photo's edge
  int found = 0;      // the found ones among them
  int not_there = 0;  // regions away from the edge that match none of them
};

bool touches_edge(const cv::Rect& box, cv::Size size) {
  return box.x < 3 || box.y < 3 || box.br().x > size.width - 3 || box.br().y > size.height - 3;
}

Score score_of(const cv::Mat& labels, const cv::Mat& truth) {
  constexpr double kSame = 0.7;  // intersection over union
  const std::vector<RegionBox> regions = region_boxes(labels);
  std::vector<char> is_used(regions.size(), 0);
  Score score;
  const std::vector<RegionBox> wanted = region_boxes(truth);
  for (std::size_t t = 1; t < wanted.size(); ++t) {
    const bool is_whole = !touches_edge(wanted[t].box, truth.size());
    score.whole += is_whole;
    for (std::size_t i = 1; i < regions.size(); ++i) {
      const double common = cv::countNonZero((truth == int(t)) & (labels == int(i)));
      if (common < kSame * (wanted[t].area_px2 + regions[i].area_px2 - common)) continue;
      is_used[i] = 1;
      score.found += is_whole;
    }
  }
  for (std::size_t i = 1; i < regions.size(); ++i) {
    if (!is_used[i] && !touches_edge(regions[i].box, truth.size())) ++score.not_there;
  }
  return score;
}

void expect_all_found(const ElementPhoto& photo, double element_px) {
  const Score score = score_of(element_labels(photo.bgr, element_px).labels(), photo.truth);
  EXPECT_GT(score.whole, 0);
  EXPECT_EQ(score.found, score.whole) << "element_px " << element_px;
  EXPECT_EQ(score.not_there, 0) << "element_px " << element_px;
}

const cv::Scalar kStone(110, 120, 130), kDarkJoint(45, 50, 55), kBrick(60, 80, 150), kMortar(170, 175, 180);

TEST(ElementLabels, DiscsOnADarkGround) { expect_all_found(photographed(test::discs(), kStone, kDarkJoint), 48); }
TEST(ElementLabels, DarkDiscsOnABrightGround) {
  expect_all_found(photographed(test::discs(), kDarkJoint, kMortar), 48);
}
TEST(ElementLabels, BricksInMortar) { expect_all_found(photographed(test::bricks(), kBrick, kMortar), 44); }
TEST(ElementLabels, Cobbles) { expect_all_found(photographed(test::cobbles(), kStone, kDarkJoint), 50); }

TEST(ElementLabels, TheSizeNeedNotBeExact) {
  const ElementPhoto photo = photographed(test::discs(), kStone, kDarkJoint);
  expect_all_found(photo, 48 * 1.4);
  expect_all_found(photo, 48 / 1.4);
}

/// A joint along the upper edge, which is one pixel wide in the copies and more: the bricks below it are whole.
TEST(ElementLabels, BesideTheEdgeOfThePhoto) {
  const ElementPhoto photo = photographed(test::bricks(), kBrick, kMortar);
  for (const int joint_px : {1, 2, 4}) {
    const cv::Rect part(0, 56 - joint_px, 420, 160 + joint_px);
    const ElementCopies copies = element_copies(photo.bgr(part).clone(), 44);
    const cv::Mat labels = elements_in_copies(copies);
    ASSERT_EQ(labels.size(), copies.fine.size());
    int beside = 0;
    for (const PhotoElement& element : find_elements(LabelRuns(labels), {.least_px = 38}).elements)
      beside += element.box.y < 14;
    EXPECT_EQ(beside, 3) << "with a joint of " << joint_px << " px";
  }
}

TEST(ElementLabels, EachIsOneRegionWithoutHoles) {
  const ElementPhoto photo = photographed(test::cobbles(), kStone, kDarkJoint);
  const cv::Mat labels = element_labels(photo.bgr, 50).labels();
  ASSERT_EQ(labels.type(), CV_32SC1);
  ASSERT_EQ(labels.size(), photo.bgr.size());
  const std::vector<RegionBox> regions = region_boxes(labels);
  ASSERT_GT(regions.size(), 20U);
  for (std::size_t i = 1; i < regions.size(); ++i) {
    ASSERT_GT(regions[i].area_px2, 0) << "label " << i << " is not used";
    const cv::Mat mask = labels(regions[i].box) == int(i);
    EXPECT_EQ(cv::countNonZero(mask != solid_part(mask)), 0) << "label " << i;
  }
}

TEST(ElementLabels, DependOnNothingButPhotoAndSize) {
  const ElementPhoto photo = photographed(test::cobbles(), kStone, kDarkJoint);
  const int threads = cv::getNumThreads();
  cv::setNumThreads(1);
  const cv::Mat on_one = element_labels(photo.bgr, 50).labels();
  cv::setNumThreads(3);
  cv::theRNG().state = 12345;
  const cv::Mat on_three = element_labels(photo.bgr, 50).labels();
  cv::setNumThreads(threads);
  EXPECT_EQ(cv::countNonZero(on_one != on_three), 0);
}

TEST(ElementLabels, NothingInAFlatPhoto) {
  const cv::Mat flat(200, 300, CV_8UC3, cv::Scalar(90, 100, 110));
  EXPECT_EQ(cv::countNonZero(element_labels(flat, 40).mask()), 0);
}

TEST(ElementLabels, NothingInPhotosSmallerThanAnElement) {
  EXPECT_TRUE(element_labels(cv::Mat(), 40).labels().empty());
  for (const cv::Size size : {cv::Size(1, 1), cv::Size(1, 500), cv::Size(500, 1), cv::Size(30, 30)}) {
    const cv::Mat labels = element_labels(cv::Mat(size, CV_8UC3, cv::Scalar(1, 2, 3)), 400).labels();
    EXPECT_EQ(labels.size(), size);
    EXPECT_EQ(cv::countNonZero(labels), 0);
  }
}

TEST(ElementLabels, RefusesBadSizesAndPhotos) {
  const cv::Mat photo(100, 100, CV_8UC3, cv::Scalar(1, 2, 3));
  const double infinity = std::numeric_limits<double>::infinity();
  for (const double size : {-1., 0., infinity, -infinity, std::nan("")}) {
    EXPECT_THROW(element_labels(photo, size), std::invalid_argument) << size;
  }
  EXPECT_THROW(element_labels(cv::Mat(100, 100, CV_8U), 40), std::invalid_argument);
  EXPECT_THROW(element_labels(cv::Mat(100, 100, CV_32FC3), 40), std::invalid_argument);
}

TEST(ElementLabels, RefusesWhatWouldNeedTooLargeACopy) {
  const cv::Mat photo(6000, 8000, CV_8UC3, cv::Scalar(1, 2, 3));
  EXPECT_THROW(element_labels(photo, 5), std::invalid_argument);
}

}  // namespace test_element_labels
}  // namespace tessera
