// The margin between an element and the photo's edge.
#include <gtest/gtest.h>

#include <opencv2/imgproc.hpp>

#include "products/elements/photo_margin.h"

namespace tessera {
namespace test_photo_margin {

const cv::Scalar kMortar(220, 220, 220), kTile(180, 120, 30);

/// 300 x 200 px with two tiles on mortar and one cut by the right edge.
/// The label of the first tile reaches over a margin of `margin_px` to the left and upper edge.
struct Tiles {
  explicit Tiles(int margin_px) : photo(200, 300, CV_8UC3, kMortar), labels(cv::Mat::zeros(200, 300, CV_32S)) {
    const cv::Rect tile(margin_px, margin_px, 80, 80), other(110, 20, 80, 80), cut(240, 60, 60, 80);
    for (const cv::Rect& r : {tile, other, cut}) photo(r) = kTile;
    cv::randu(noise_, 0, 30);
    photo -= noise_;
    labels(cv::Rect({}, tile.br())) = 1;
    labels(other) = 2;
    labels(cut) = 3;
  }

  cv::Rect box(int label) const { return without_margins(photo, LabelRuns(labels)).regions()[std::size_t(label)].box; }

  cv::Mat photo, labels;

 private:
  cv::Mat noise_ = cv::Mat(200, 300, CV_8UC3);
};

TEST(PhotoMargin, IsTakenFromATileThatTheEdgeDoesNotCut) {
  for (const int margin_px : {1, 3, 5}) {
    const Tiles tiles(margin_px);
    EXPECT_EQ(tiles.box(1), cv::Rect(margin_px, margin_px, 80, 80)) << margin_px;
  }
}

/// The window around a large tile is examined in a smaller copy.
TEST(PhotoMargin, OfALargeTileIsFoundInACopy) {
  cv::Mat photo(2000, 2400, CV_8UC3, kMortar), labels = cv::Mat::zeros(2000, 2400, CV_32S);
  const cv::Rect tile(24, 24, 1800, 1800);
  photo(tile) = kTile;
  labels(cv::Rect({}, tile.br())) = 1;
  const cv::Rect box = without_margins(photo, LabelRuns(labels)).regions()[1].box;
  EXPECT_NEAR(box.x, tile.x, 2);
  EXPECT_NEAR(box.y, tile.y, 2);
  EXPECT_EQ(box.br(), tile.br());
}

TEST(PhotoMargin, WhatTheEdgeCutsReachesItStill) {
  const Tiles tiles(3);
  EXPECT_EQ(tiles.box(3), cv::Rect(240, 60, 60, 80));
  EXPECT_EQ(tiles.box(2), cv::Rect(110, 20, 80, 80)) << "and who does not reach it stays as it is";
}

/// Broad margins also show in a coarse copy, but no more than this width is removed.
TEST(PhotoMargin, IsNarrow) { EXPECT_EQ(Tiles(20).box(1).tl(), cv::Point(8, 8)); }

TEST(PhotoMargin, OfNothingIsNothing) {
  EXPECT_EQ(without_margins(cv::Mat(9, 9, CV_8UC3, kTile), LabelRuns(cv::Mat::zeros(9, 9, CV_32S))).regions().size(),
            1u);
  // One element fills the photo, so there is no gap to compare with.
  EXPECT_EQ(
      without_margins(cv::Mat(9, 9, CV_8UC3, kTile), LabelRuns(cv::Mat::ones(9, 9, CV_32S))).regions()[1].area_px2, 81);
}

}  // namespace test_photo_margin
}  // namespace tessera
