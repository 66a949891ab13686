// The parts of the search for elements.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <array>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "products/elements/gap_filter.h"
#include "products/elements/segmentation/boundary_map.h"
#include "products/elements/segmentation/colour_clusters.h"
#include "products/elements/segmentation/distance_split.h"
#include "products/elements/segmentation/label_scaling.h"
#include "products/elements/segmentation/mask_parts.h"
#include "products/elements/segmentation/merge_tree.h"
#include "products/elements/segmentation/region_labels.h"
#include "products/elements/segmentation/region_vote.h"
#include "products/elements/segmentation/relief_watershed.h"
#include "products/elements/trim.h"

namespace tessera {
namespace test_element_regions {

int label_count(const cv::Mat& labels) { return int(region_boxes(labels).size()) - 1; }

cv::Mat random_relief(int width, int height, int levels) {
  const auto values = *rc::gen::container<std::vector<int>>(std::size_t(width * height), rc::gen::inRange(0, levels));
  cv::Mat relief(height, width, CV_32F);
  for (int i = 0; i < width * height; ++i) relief.at<float>(i / width, i % width) = float(values[std::size_t(i)]);
  return relief;
}

TEST(ReliefWatershed, WaterMeetsOnTheRidge) {
  const cv::Mat relief = (cv::Mat_<float>(1, 9) << 2, 1, 0, 3, 5, 4, 2, 3, 4);
  const cv::Mat basins = basins_of(relief);
  const cv::Mat expected = (cv::Mat_<int>(1, 9) << 1, 1, 1, 1, 0, 2, 2, 2, 2);
  for (int x = 0; x < 9; ++x) {
    if (x == 4) continue;  // the ridge may belong to either side
    EXPECT_EQ(basins.at<int>(x), expected.at<int>(x)) << x;
  }
}

RC_GTEST_PROP(ReliefWatershed, EachBasinIsConnectedAndEveryPixelIsFlooded, ()) {
  const cv::Mat basins = basins_of(random_relief(*rc::gen::inRange(1, 12), *rc::gen::inRange(1, 12), 4));
  const std::vector<RegionBox> regions = region_boxes(basins);
  RC_ASSERT(cv::countNonZero(basins <= 0) == 0);
  for (int i = 1; i < int(regions.size()); ++i) {
    cv::Mat parts;
    RC_ASSERT(cv::connectedComponents(basins == i, parts, 4) == 2);
  }
}

TEST(ReliefWatershed, StaysWithinTheMask) {
  const cv::Mat relief = (cv::Mat_<float>(1, 5) << 2, 1, 0, 1, 2);
  const cv::Mat mask = (cv::Mat_<std::uint8_t>(1, 5) << 255, 255, 0, 255, 255);
  EXPECT_EQ(cv::countNonZero(basins_of(relief, mask) != (cv::Mat_<int>(1, 5) << 1, 1, 0, 2, 2)), 0);
}

TEST(MergedBasins, ShallowOnesJoinTheirNeighbour) {
  const cv::Mat relief = (cv::Mat_<float>(1, 7) << 0, 3, 2, 9, 1, 5, 4);
  const cv::Mat basins = basins_of(relief);
  EXPECT_EQ(label_count(basins), 4);
  const BasinMerger merger(relief, basins);
  const auto deeper_than = [&](float depth) {
    return merger.merged([depth](float saddle, float floor) { return saddle - floor < depth; });
  };
  EXPECT_EQ(label_count(deeper_than(0.5F)), 4);
  EXPECT_EQ(label_count(deeper_than(2)), 2);
  EXPECT_EQ(label_count(deeper_than(100)), 1);
}

TEST(SplitByDistance, TouchingDiscsAreTwoAndALongOneIsOne) {
  cv::Mat mask = cv::Mat::zeros(100, 200, CV_8U);
  cv::circle(mask, {60, 50}, 25, 255, cv::FILLED);
  cv::circle(mask, {107, 50}, 25, 255, cv::FILLED);
  const cv::Mat parts = split_by_distance(mask);
  EXPECT_EQ(label_count(parts), 2);
  EXPECT_NE(parts.at<int>(50, 60), parts.at<int>(50, 107));
  mask.setTo(0);
  cv::rectangle(mask, {20, 30}, {180, 70}, 255, cv::FILLED);
  EXPECT_EQ(label_count(split_by_distance(mask)), 1);
}

TEST(SplitByDistance, LeavesOutSlivers) {
  cv::Mat mask = cv::Mat::zeros(60, 100, CV_8U);
  cv::rectangle(mask, {10, 30}, {90, 33}, 255, cv::FILLED);
  EXPECT_EQ(cv::countNonZero(split_by_distance(mask)), 0);
}

TEST(SolidPart, FillsHolesAndKeepsTheLargest) {
  cv::Mat mask = cv::Mat::zeros(30, 40, CV_8U);
  cv::rectangle(mask, {0, 0}, {19, 19}, 255, cv::FILLED);
  cv::rectangle(mask, {5, 5}, {9, 9}, 0, cv::FILLED);
  cv::rectangle(mask, {20, 20}, {25, 25}, 255, cv::FILLED);  // touches only by a corner
  const cv::Mat solid = solid_part(mask);
  EXPECT_EQ(cv::countNonZero(solid), 400);
  EXPECT_EQ(solid.at<std::uint8_t>(7, 7), 255);
  EXPECT_EQ(solid.at<std::uint8_t>(20, 20), 0);
}

/// Compares random masks with OpenCV's connected components.
RC_GTEST_PROP(MaskParts, AreTheConnectedComponents, ()) {
  const cv::Mat mask = random_relief(*rc::gen::inRange(1, 20), *rc::gen::inRange(1, 20), 3) > 0;
  cv::Mat labels, stats, centroids;
  const int count = cv::connectedComponentsWithStats(mask, labels, stats, centroids, 4);
  using Part = std::array<int, 5>;
  std::vector<Part> expected, found;
  for (int i = 1; i < count; ++i) {
    const int* s = stats.ptr<int>(i);
    expected.push_back(
        {s[cv::CC_STAT_LEFT], s[cv::CC_STAT_TOP], s[cv::CC_STAT_WIDTH], s[cv::CC_STAT_HEIGHT], s[cv::CC_STAT_AREA]});
  }
  for (const auto& [box, area_px2] : mask_parts(mask))
    found.push_back({box.x, box.y, box.width, box.height, int(area_px2)});
  std::sort(expected.begin(), expected.end());
  std::sort(found.begin(), found.end());
  RC_ASSERT(found == expected);
}

/// Compares random masks with OpenCV's connected components.
RC_GTEST_PROP(SolidPart, IsTheLargestComponentAndAllThatItEncloses, ()) {
  const cv::Mat mask = random_relief(*rc::gen::inRange(1, 20), *rc::gen::inRange(1, 20), 3) > 0;
  cv::Mat parts, stats, centroids;
  const int count = cv::connectedComponentsWithStats(mask, parts, stats, centroids, 4);
  const cv::Mat solid = solid_part(mask);
  int most_px2 = 0;
  for (int i = 1; i < count; ++i) most_px2 = std::max(most_px2, stats.at<int>(i, cv::CC_STAT_AREA));
  cv::Mat framed, grounds;
  cv::copyMakeBorder(solid == 0, framed, 1, 1, 1, 1, cv::BORDER_CONSTANT, 255);
  RC_ASSERT(cv::connectedComponents(framed, grounds, 8) == 2);  // no enclosed ground is left
  RC_ASSERT(cv::countNonZero(solid & mask) >= most_px2);
  if (most_px2 > 0) {
    RC_ASSERT(cv::connectedComponents(solid, parts, 4) == 2);  // there is only one part
  } else {
    RC_ASSERT(cv::countNonZero(solid) == 0);
  }
}

TEST(Solidity, IsTheAreaByItsHull) {
  EXPECT_DOUBLE_EQ(solidity_of(cv::Mat::ones(7, 9, CV_8U)), 1);
  EXPECT_DOUBLE_EQ(solidity_of(cv::Mat::zeros(7, 9, CV_8U)), 0);
  cv::Mat corner = cv::Mat::ones(10, 10, CV_8U);
  corner(cv::Rect(5, 5, 5, 5)).setTo(0);
  EXPECT_DOUBLE_EQ(solidity_of(corner), 75 / 87.5);
}

/// Compares random masks with OpenCV's convex hull.
RC_GTEST_PROP(Solidity, IsThePartOfTheConvexHullOfThePixelsSquares, ()) {
  cv::Mat mask = random_relief(*rc::gen::inRange(1, 12), *rc::gen::inRange(1, 12), 4) > 2;
  mask.at<std::uint8_t>(0, 0) = 255;  // is not empty
  std::vector<cv::Point> pixels, corners, hull;
  cv::findNonZero(mask, pixels);
  for (const cv::Point& p : pixels) {
    for (const cv::Point corner : {cv::Point(0, 0), {1, 0}, {0, 1}, {1, 1}}) corners.push_back(p + corner);
  }
  cv::convexHull(corners, hull);
  RC_ASSERT(solidity_of(mask) == double(pixels.size()) / cv::contourArea(hull));
}

/// Negative values, too, and many equal ones.
RC_GTEST_PROP(Quantile, IsTheValueAtItsPlaceInOrder, ()) {
  const cv::Mat relief = random_relief(*rc::gen::inRange(1, 12), *rc::gen::inRange(1, 12), 20);
  const cv::Mat map = (relief - 9) * 0.37;
  const double fraction = *rc::gen::inRange(0, 101) / 100.;
  std::vector<float> values(map.begin<float>(), map.end<float>());
  std::sort(values.begin(), values.end());
  RC_ASSERT(quantile_of(map, fraction) == values[std::size_t(fraction * double(values.size() - 1))]);
}

TEST(SolidRegions, TheRegionInAHoleBecomesPartOfIt) {
  cv::Mat labels = cv::Mat::zeros(20, 20, CV_32S);
  labels(cv::Rect(2, 2, 14, 14)).setTo(1);
  labels(cv::Rect(6, 6, 4, 4)).setTo(2);
  labels(cv::Rect(18, 18, 2, 2)).setTo(3);
  const cv::Mat solid = solid_regions(labels, 5, 0);
  EXPECT_EQ(label_count(solid), 1);
  EXPECT_EQ(cv::countNonZero(solid), 14 * 14);
}

TEST(ColourClusters, ThreeColoursAreThree) {
  cv::Mat colours(30, 30, CV_32FC3, cv::Scalar(10, 0, 0));
  colours.rowRange(10, 20).setTo(cv::Scalar(50, 20, 0));
  colours.rowRange(20, 30).setTo(cv::Scalar(90, 0, 30));
  const cv::Mat clusters = colour_clusters(colours, 3);
  for (int band = 0; band < 3; ++band) {
    const int cluster = clusters.at<std::uint8_t>(band * 10, 0);
    EXPECT_EQ(cv::countNonZero(clusters == cluster), 300);
    EXPECT_EQ(cv::countNonZero(clusters.rowRange(band * 10, band * 10 + 10) == cluster), 300);
  }
}

TEST(MergeTree, CutsWhereBordersAreStrong) {
  // Two squares of four parts each. Lines within a square are faint, lines between and around squares strong.
  cv::Mat boundary(40, 80, CV_32F, cv::Scalar(0.05));
  boundary.row(20).setTo(0.2);
  boundary.col(20).setTo(0.2);
  boundary.col(60).setTo(0.2);
  boundary.col(40).setTo(1.2);
  cv::Mat leaves(40, 80, CV_32S);
  for (int y = 0; y < 40; ++y) {
    for (int x = 0; x < 80; ++x) leaves.at<int>(y, x) = y / 20 * 4 + x / 20 + 1;
  }
  const cv::Mat labels = best_of_merge_tree(boundary, leaves, 4);
  EXPECT_EQ(label_count(labels), 2);
  EXPECT_EQ(labels.at<int>(5, 5), labels.at<int>(35, 35));
  EXPECT_NE(labels.at<int>(5, 35), labels.at<int>(5, 45));
}

RC_GTEST_PROP(LabelRuns, AreTheMapAgain, ()) {
  const int width = *rc::gen::inRange(1, 14), height = *rc::gen::inRange(1, 14);
  cv::Mat labels;
  random_relief(width, height, 4).convertTo(labels, CV_32S);
  const LabelRuns runs(labels);
  RC_ASSERT(cv::countNonZero(runs.labels() != labels) == 0);
  const std::vector<RegionBox> regions = region_boxes(labels);
  RC_ASSERT(runs.regions().size() == regions.size());
  for (std::size_t i = 1; i < regions.size(); ++i) {
    if (regions[i].area_px2 == 0) continue;
    RC_ASSERT(cv::countNonZero(runs.mask_of(i) != (labels(regions[i].box) == int(i))) == 0);
  }
}

cv::Mat with_squares(const std::vector<cv::Rect>& squares) {
  cv::Mat labels = cv::Mat::zeros(120, 120, CV_32S);
  for (std::size_t i = 0; i < squares.size(); ++i) labels(squares[i]).setTo(int(i) + 1);
  return labels;
}

TEST(RegionVote, KeepsWhatOthersAgreeWith) {
  const cv::Rect agreed(10, 10, 40, 40), alone(70, 70, 40, 40);
  std::vector<LabelRuns> maps(7, LabelRuns(with_squares({agreed})));
  maps.emplace_back(with_squares({agreed, alone}));
  const cv::Mat voted = voted_regions(maps, cv::Mat::ones(120, 120, CV_32F), 40).labels;
  EXPECT_EQ(label_count(voted), 1);
  EXPECT_EQ(cv::countNonZero(voted(agreed)), 1600);
  EXPECT_EQ(cv::countNonZero(voted), 1600);
}

TEST(RegionVote, TheMoreVotedForKeepsTheOtherOff) {
  const cv::Rect better(10, 10, 40, 40), worse(20, 10, 40, 40);
  std::vector<LabelRuns> maps(5, LabelRuns(with_squares({better})));
  for (int i = 0; i < 3; ++i) maps.emplace_back(with_squares({worse}));
  const cv::Mat voted = voted_regions(maps, cv::Mat::ones(120, 120, CV_32F), 40).labels;
  EXPECT_EQ(label_count(voted), 1);
  EXPECT_EQ(cv::countNonZero(voted(better)), 1600);
}

TEST(RegionVote, GroundCutFromGroundIsNoElement) {
  const cv::Rect square(10, 10, 40, 40);
  const std::vector<LabelRuns> maps(4, LabelRuns(with_squares({square})));
  cv::Mat boundary = cv::Mat::zeros(120, 120, CV_32F);
  cv::rectangle(boundary, square, 1, 1);
  EXPECT_EQ(label_count(voted_regions(maps, boundary, 40).labels), 1);
  boundary.colRange(30, 120).setTo(0);
  EXPECT_EQ(label_count(voted_regions(maps, boundary, 40).labels), 0);
}

TEST(RegionVote, VotesMakeUpForAWeakBorder) {
  const cv::Rect agreed(10, 10, 40, 40), rare(70, 70, 40, 40);
  std::vector<LabelRuns> maps(16, LabelRuns(with_squares({agreed})));
  for (int i = 0; i < 3; ++i) maps.emplace_back(with_squares({agreed, rare}));  // two others of eighteen agree
  const auto voted = [&](double border) { return voted_regions(maps, cv::Mat(120, 120, CV_32F, border), 40).labels; };
  EXPECT_EQ(label_count(voted(0.41)), 2);
  const cv::Mat weak = voted(0.36);
  EXPECT_EQ(label_count(weak), 1);
  EXPECT_EQ(cv::countNonZero(weak(agreed)), 1600);
  EXPECT_EQ(label_count(voted(0.34)), 0) << "nothing makes up for no border";
}

/// Bright squares on a dark ground. One labelled square has the colour of the ground.
TEST(GapFilter, GroundGoesButNotWhatHasAJointAroundIt) {
  cv::Mat photo(240, 320, CV_8UC3, cv::Scalar(40, 45, 50));
  cv::Mat labels = cv::Mat::zeros(240, 320, CV_32S);
  int next = 0;
  for (int i = 0; i < 12; ++i) {
    const cv::Rect square(20 + i % 4 * 76, 20 + i / 4 * 76, 40, 40);
    labels(square).setTo(++next);
    if (i != 5) photo(square).setTo(cv::Scalar(140, 150, 160));
  }
  cv::RNG random(3);
  cv::Mat noise(photo.size(), CV_8UC3);
  random.fill(noise, cv::RNG::UNIFORM, 0, 12);
  photo += noise;
  const cv::Mat kept = without_gap_regions(labels, photo, smooth_lab(photo));
  EXPECT_EQ(label_count(kept), 11);
  EXPECT_EQ(kept.at<int>(116, 116), 0);
}

TEST(ScaledLabels, KeepTheirPlaceAndArea) {
  cv::Mat labels = cv::Mat::zeros(60, 80, CV_32S);
  cv::circle(labels, {40, 30}, 20, 1, cv::FILLED);
  const double area_px2 = region_boxes(labels)[1].area_px2;
  const RegionBox scaled = scaled_labels(labels, {320, 240}).regions()[1];
  EXPECT_NEAR(scaled.area_px2 / 16, area_px2, 0.03 * area_px2);
  EXPECT_NEAR(scaled.box.x + scaled.box.width / 2., 40.5 * 4, 2);
  EXPECT_NEAR(scaled.box.y + scaled.box.height / 2., 30.5 * 4, 2);
}

TEST(ScaledLabels, WhatThePhotosEdgeCutsStaysCut) {
  cv::Mat labels = cv::Mat::zeros(60, 80, CV_32S);
  labels(cv::Rect(0, 10, 30, 40)).setTo(1);
  EXPECT_EQ(scaled_labels(labels, {200, 150}).regions()[1].box.x, 0);
}

/// A stone of radius `stone_px` inside one region, which also holds a rim of another lightness.
struct RimmedStone {
  RimmedStone(int stone_px, int region_px, float stone_lightness, float rim_lightness)
      : labels(80, 80, CV_32S, cv::Scalar(0)),
        lab(80, 80, CV_32FC3, cv::Scalar(rim_lightness, 0, 0)) {
    cv::circle(labels, {40, 40}, region_px, cv::Scalar(1), cv::FILLED);
    cv::circle(lab, {40, 40}, stone_px, cv::Scalar(stone_lightness, 0, 0), cv::FILLED);
  }
  int area() const { return cv::countNonZero(trimmed_regions(labels, lab)); }

  cv::Mat labels, lab;
};

int disc_area(int radius_px) {
  cv::Mat disc(80, 80, CV_8U, cv::Scalar(0));
  cv::circle(disc, {40, 40}, radius_px, cv::Scalar(1), cv::FILLED);
  return cv::countNonZero(disc);
}

TEST(Trim, TakesOffARimInTheGapsColour) {
  const RimmedStone stone(20, 24, 70, 30);
  EXPECT_NEAR(stone.area(), disc_area(20), 0.08 * disc_area(20));
  const cv::Mat trimmed = trimmed_regions(stone.labels, stone.lab);
  EXPECT_EQ(trimmed.at<int>(40, 40), 1);
  EXPECT_EQ(trimmed.at<int>(40, 63), 0) << "the rim";
}

TEST(Trim, LeavesARegionOfOneColourAlone) {
  EXPECT_EQ(RimmedStone(20, 24, 70, 67).area(), disc_area(24)) << "3 apart are one colour";
  EXPECT_LT(RimmedStone(20, 24, 70, 62).area(), disc_area(22)) << "8 are two";
}

/// Such a region is something else: a ring, or two elements taken for one.
TEST(Trim, NeverTakesMoreThanHalf) { EXPECT_EQ(RimmedStone(15, 24, 70, 30).area(), disc_area(24)); }

TEST(Trim, LeavesWhatIsTooSmallAlone) { EXPECT_EQ(RimmedStone(3, 4, 70, 30).area(), disc_area(4)); }

}  // namespace test_element_regions
}  // namespace tessera
