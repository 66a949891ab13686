// Found elements compared with truth maps: drawn maps, the maps of bench/truth, and the search in a photo.
#include "element_truth.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <filesystem>
#include <opencv2/imgproc.hpp>
#include <string>
#include <vector>

#include "artwork/images/png_encoder.h"
#include "files/regular_file.h"
#include "support/images.h"
#include "support/input_error.h"
#include "support/scratch_folder.h"

namespace tessera::bench {
namespace test_element_truth {

constexpr int kIgnored = kFirstIgnored;
const std::string kMaps = std::string(TESSERA_SOURCE_DIR) + "/bench/truth/";

/// A map of rectangles: 0 elsewhere.
class DrawnMap {
 public:
  explicit DrawnMap(int background = 0) : labels_(100, 200, CV_32S, cv::Scalar(background)) {}
  DrawnMap& with(int label, const cv::Rect& box) {
    labels_(box) = label;
    return *this;
  }
  const cv::Mat& labels() const { return labels_; }

 private:
  cv::Mat labels_;
};

TruthComparison comparison_of(const DrawnMap& truth, const DrawnMap& found) {
  const LabelRuns labels(found.labels());
  return compared_with_truth(truth.labels(), labels, find_elements(labels, {}).elements);
}

TEST(ElementTruth, AnElementMatchesFromHalfOfTheUnionOn) {
  const DrawnMap truth = DrawnMap().with(7, {10, 10, 40, 20}).with(9, {100, 50, 40, 20});
  const TruthComparison half = comparison_of(truth, DrawnMap().with(1, {30, 10, 20, 20}).with(2, {101, 50, 19, 20}));
  EXPECT_EQ(half.whole, (std::vector<int>{7, 9}));
  EXPECT_EQ(half.counted(), 2U);
  for (const std::vector<TruthMatch>& matches : {half.by_boxes, half.by_masks}) {
    ASSERT_EQ(matches.size(), 1U) << "the other one overlaps by less than half: missed, and false";
    EXPECT_EQ(matches[0].truth, 7);
    EXPECT_EQ(matches[0].element, 0U);
    EXPECT_DOUBLE_EQ(matches[0].overlap, 0.5);
  }
}

TEST(ElementTruth, MatchesAreOneToOneTheGreatestOverlapFirst) {
  const DrawnMap truth = DrawnMap().with(1, {10, 10, 100, 40});
  // The box of the second one, an L, is the element's box. The first one has more of its pixels.
  const DrawnMap found = DrawnMap().with(2, {10, 10, 100, 40}).with(1, {10, 10, 90, 30});
  const TruthComparison comparison = comparison_of(truth, found);
  ASSERT_EQ(comparison.by_boxes.size(), 1U);
  ASSERT_EQ(comparison.by_masks.size(), 1U);
  EXPECT_DOUBLE_EQ(comparison.by_boxes[0].overlap, 1);
  EXPECT_DOUBLE_EQ(comparison.by_masks[0].overlap, 2700 / 4000.);
  EXPECT_NE(comparison.by_boxes[0].element, comparison.by_masks[0].element);
  // The other way round one found element has the box of two whole ones, and matches the better one.
  const TruthComparison turned = comparison_of(found, truth);
  ASSERT_EQ(turned.by_boxes.size(), 1U);
  EXPECT_EQ(turned.by_boxes[0].truth, 2);
  ASSERT_EQ(turned.by_masks.size(), 1U);
  EXPECT_EQ(turned.by_masks[0].truth, 1);
}

TEST(ElementTruth, AnElementMostlyInIgnoredPixelsCountsNeitherWay) {
  const auto counted = [](int left, int right) {
    const DrawnMap truth =
        DrawnMap().with(left, {10, 10, 20, 20}).with(right, {30, 10, 11, 20}).with(1, {100, 10, 40, 40});
    return comparison_of(truth, DrawnMap().with(1, {10, 10, 40, 20}).with(2, {100, 10, 40, 40})).counted();
  };
  EXPECT_EQ(counted(kIgnored, 0), 2U) << "half of its pixels";
  EXPECT_EQ(counted(kIgnored, kIgnored + 1), 1U) << "more than half, in two regions";
  EXPECT_EQ(counted(kIgnored, kUnmarked), 1U);
  EXPECT_EQ(counted(kUnmarked, kUnmarked), 1U);
  EXPECT_EQ(counted(0, 0), 2U);
  EXPECT_EQ(counted(kMostWhole, 0), 2U);
}

TEST(ElementTruth, AnElementMostlyInIgnoredPixelsMatchesNothing) {
  // Filler in the middle of an element, whose box it nearly fills.
  const DrawnMap truth = DrawnMap().with(1, {10, 10, 40, 20}).with(kIgnored, {12, 12, 36, 16});
  EXPECT_EQ(comparison_of(truth, DrawnMap().with(1, {10, 10, 40, 20})).by_boxes.size(), 0U);
  const TruthComparison filler = comparison_of(truth, DrawnMap().with(1, {12, 12, 36, 16}));
  EXPECT_TRUE(filler.by_boxes.empty());
  EXPECT_EQ(filler.counted(), 0U);
  EXPECT_EQ(filler.whole.size(), 1U) << "missed";
}

TEST(ElementTruth, OutsideTheMarkedCropNothingCounts) {
  const DrawnMap crop = DrawnMap(kUnmarked).with(0, {50, 20, 100, 60}).with(1, {60, 30, 20, 20});
  const TruthComparison comparison =
      comparison_of(crop, DrawnMap().with(1, {60, 30, 20, 20}).with(2, {10, 10, 30, 30}).with(3, {140, 30, 20, 20}));
  EXPECT_EQ(comparison.whole, std::vector<int>{1});
  EXPECT_EQ(comparison.by_masks.size(), 1U);
  EXPECT_EQ(comparison.counted(), 2U) << "half of the third one lies on ground, where nothing is";
}

TEST(ElementTruth, ElementsAtTheEdgeAreNoneOfTheFoundOnes) {
  const DrawnMap truth = DrawnMap().with(1, {1, 10, 40, 20});
  const TruthComparison comparison = comparison_of(truth, DrawnMap().with(1, {0, 10, 41, 20}));
  EXPECT_EQ(comparison.counted(), 0U);
  EXPECT_TRUE(comparison.by_boxes.empty());
}

TEST(ElementTruth, SplitElements) {
  const DrawnMap truth = DrawnMap().with(1, {10, 10, 60, 40}).with(2, {100, 10, 60, 40});
  const DrawnMap found = DrawnMap()
                             .with(1, {10, 10, 40, 40})    // matches
                             .with(2, {52, 10, 18, 40})    // the rest of the same one
                             .with(3, {100, 10, 29, 40})   // less than half
                             .with(4, {140, 10, 41, 40});  // mostly on ground
  const TruthComparison comparison = comparison_of(truth, found);
  EXPECT_EQ(comparison.split, std::vector<int>{1});
  EXPECT_EQ(comparison.by_masks.size(), 1U);
  EXPECT_EQ(comparison.counted(), 4U);
  EXPECT_TRUE(comparison.merged.empty());
}

TEST(ElementTruth, MergedElements) {
  const DrawnMap truth = DrawnMap()
                             .with(1, {10, 10, 30, 40})
                             .with(2, {42, 10, 30, 40})
                             .with(3, {74, 10, 30, 40})
                             .with(kIgnored, {110, 10, 20, 40})
                             .with(4, {132, 10, 30, 40});
  // The first one covers the first two and half of the third, the second one an ignored element, too.
  const TruthComparison comparison =
      comparison_of(truth, DrawnMap().with(1, {10, 10, 79, 40}).with(2, {110, 10, 52, 40}));
  EXPECT_EQ(comparison.merged, std::vector<std::size_t>{0});
  EXPECT_TRUE(comparison.split.empty());
  ASSERT_EQ(comparison.by_masks.size(), 1U);
  EXPECT_EQ(comparison.by_masks[0].truth, 4);
  EXPECT_EQ(comparison_of(truth, DrawnMap().with(1, {10, 10, 80, 40})).merged.size(), 1U) << "once, although of three";
  EXPECT_TRUE(comparison_of(truth, DrawnMap().with(1, {42, 10, 47, 40})).merged.empty()) << "one and a half";
}

TEST(ElementTruth, NothingFoundOrNothingMarked) {
  const DrawnMap one = DrawnMap().with(1, {10, 10, 30, 40}), none;
  EXPECT_EQ(comparison_of(one, none).whole.size(), 1U);
  EXPECT_EQ(comparison_of(one, none).counted(), 0U);
  EXPECT_EQ(comparison_of(none, one).whole.size(), 0U);
  EXPECT_EQ(comparison_of(none, one).counted(), 1U);
}

/// A photo of discs on grey, in a file, with its truth map.
class ElementTruthFiles : public testing::Test {
 protected:
  std::string photo() const {
    cv::Mat pixels(90, 300, CV_8UC3, cv::Scalar(90, 90, 90));
    for (int i = 0; i < 4; ++i) cv::circle(pixels, {45 + 70 * i, 45}, kRadius_px, {40, 120, 230}, cv::FILLED);
    return written("discs.png", pixels);
  }
  std::string map(int label, cv::Size size = {300, 90}) const {
    cv::Mat labels(size, CV_16U, cv::Scalar(0));
    for (int i = 0; i < 4; ++i) cv::circle(labels, {45 + 70 * i, 45}, kRadius_px, label + i, cv::FILLED);
    return written("map.png", labels);
  }
  std::string written(const std::string& name, const cv::Mat& image) const {
    const std::vector<std::uint8_t> png = png_of(image);
    return folder_.write(name, std::string(png.begin(), png.end()));
  }

  static constexpr int kRadius_px = 12;
  test::ScratchFolder folder_;
  Drawers drawers_{DrawerSettings{}};
};

TEST_F(ElementTruthFiles, TheMapIsEnlargedLikeThePhoto) {
  const PhotoComparison result = compared_photo(photo(), map(1), 0, drawers_);
  EXPECT_EQ(result.extraction.enlarged, 2) << "discs of 21 px: the side of a square of their area";
  EXPECT_EQ(result.truth.size(), cv::Size(600, 180));
  EXPECT_EQ(result.comparison.by_masks.size(), 4U);
  EXPECT_EQ(result.comparison.counted(), 4U);
  EXPECT_GT(result.comparison.by_masks.back().overlap, 0.85);
}

TEST_F(ElementTruthFiles, MapsOfAnotherSizeOrWithOtherLabelsAreRefused) {
  const std::string of_size = test::message_of([&] { compared_photo(photo(), map(1, {300, 91}), 0, drawers_); });
  EXPECT_NE(of_size.find("found a map of 300 x 91 px, allowed: the photo's size, 300 x 90 px"), std::string::npos)
      << of_size;
  const std::string of_label = test::message_of([&] { compared_photo(photo(), map(997), 0, drawers_); });
  EXPECT_NE(of_label.find("found the label 1000, allowed: 0 to 999 and 1001 to 65535"), std::string::npos) << of_label;
}

TEST_F(ElementTruthFiles, EachMapOfTheRepositoryHasWholeElementsAndOnlyLabelsOfTruthMaps) {
  int maps = 0;
  for (const auto& file : std::filesystem::directory_iterator(kMaps)) {
    if (file.path().extension() != ".png") continue;
    const cv::Mat labels = drawers_.labels(read_regular_file(file.path(), kMaxPhotoBytes), file.path());
    EXPECT_NO_THROW(check_truth(labels, file.path())) << file.path();
    const LabelRuns none(cv::Mat::zeros(labels.size(), CV_32S));
    EXPECT_GE(compared_with_truth(labels, none, {}).whole.size(), 15U) << file.path();
    ++maps;
  }
  EXPECT_EQ(maps, 11);
}

/// A marked part of jobs/photos/gravel.png, searched alone.
TEST_F(ElementTruthFiles, TheSearchFindsGravel) {
  const cv::Rect part(170, 170, 170, 170);
  const cv::Mat gravel = test::read_image(std::string(TESSERA_SOURCE_DIR) + "/jobs/photos/gravel.png");
  const std::string map = kMaps + "gravel.png";
  cv::Mat labels;
  drawers_.labels(read_regular_file(map, kMaxPhotoBytes), map)(part).convertTo(labels, CV_16U);
  const PhotoComparison result =
      compared_photo(written("gravel.png", gravel(part)), written("map.png", labels), 0, drawers_);
  const TruthComparison& comparison = result.comparison;
  const double found = double(comparison.by_masks.size());
  // Measured: 60 of 85 stones, and 17 others. When all borders had to be strong it was 52 and 8.
  EXPECT_GE(found / double(comparison.whole.size()), 0.67);
  EXPECT_GE(found / double(comparison.counted()), 0.75);
}

}  // namespace test_element_truth
}  // namespace tessera::bench
