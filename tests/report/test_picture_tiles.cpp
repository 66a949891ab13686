// Pyramids of WebP tiles.
#include <gtest/gtest.h>
#include <webp/decode.h>

#include <opencv2/imgproc.hpp>

#include "report/picture_tiles.h"

namespace tessera {
namespace test_picture_tiles {

/// Flat discs on a ground, as clip art has them, and a transparent corner.
cv::Mat picture(int width_px, int height_px) {
  cv::Mat bgra(height_px, width_px, CV_8UC4, cv::Scalar(230, 240, 250, 255));
  for (int k = 0; k < 60; ++k) {
    cv::circle(bgra, {k * 97 % width_px, k * 61 % height_px}, 20 + k, cv::Scalar(k * 4, 255 - k * 3, k * 37 % 255, 255),
               cv::FILLED, cv::LINE_AA);
  }
  bgra(cv::Rect(0, 0, 40, 40)).setTo(cv::Scalar::all(0));
  return bgra;
}

cv::Mat decoded(const std::vector<std::uint8_t>& webp) {
  int width = 0, height = 0;
  std::uint8_t* bgra = WebPDecodeBGRA(webp.data(), webp.size(), &width, &height);
  const cv::Mat copy = cv::Mat(height, width, CV_8UC4, bgra).clone();
  WebPFree(bgra);
  return copy;
}

TEST(PictureTiles, levels_halve_down_to_one_tile) {
  const PicturePyramid pyramid = picture_pyramid(picture(1100, 700), 10'000'000);
  ASSERT_EQ(pyramid.size(), 3u);
  EXPECT_EQ(pyramid[0].size_px, cv::Size(1100, 700));
  EXPECT_EQ(pyramid[1].size_px, cv::Size(550, 350));
  EXPECT_EQ(pyramid[2].size_px, cv::Size(275, 175));
  EXPECT_EQ(pyramid[0].columns, 3);
  EXPECT_EQ(pyramid[0].tiles.size(), 6u);
  EXPECT_EQ(decoded(pyramid[0].tiles[5]).size(), cv::Size(1100 - 1024, 700 - 512)) << "the last tile of the last row";
}

TEST(PictureTiles, tiles_show_their_part_of_the_picture) {
  const cv::Mat whole = picture(1100, 700);
  const PicturePyramid pyramid = picture_pyramid(whole, 10'000'000);
  const cv::Mat tile = decoded(pyramid[0].tiles[4]);  // second column, second row
  cv::Mat difference;
  cv::absdiff(tile, whole(cv::Rect(512, 512, tile.cols, tile.rows)), difference);
  EXPECT_LT(cv::mean(difference)[0], 4) << "of 255, mean of blue";
  EXPECT_EQ(decoded(pyramid[0].tiles[0]).at<cv::Vec4b>(20, 20)[3], 0) << "the transparent corner";
}

TEST(PictureTiles, keep_to_their_bytes) {
  const cv::Mat large = picture(3000, 2400);
  const std::size_t all = bytes_of(picture_pyramid(large, 100'000'000));
  for (const std::size_t most : {all / 2, all / 5, all / 50}) {
    const PicturePyramid pyramid = picture_pyramid(large, most);
    EXPECT_LE(bytes_of(pyramid), most);
    EXPECT_GT(bytes_of(pyramid), most / 3) << "the budget is used";
    EXPECT_NEAR(double(pyramid[0].size_px.width) / pyramid[0].size_px.height, 1.25, 0.02);
  }
}

TEST(PictureTiles, one_tile_is_always_made) {
  const PicturePyramid pyramid = picture_pyramid(picture(900, 600), 10);
  ASSERT_EQ(pyramid.size(), 1u);
  EXPECT_GT(pyramid[0].size_px.width, 10);
}

TEST(PictureTiles, the_same_picture_gives_the_same_bytes) {
  const PicturePyramid once = picture_pyramid(picture(1100, 700), 30'000),
                       again = picture_pyramid(picture(1100, 700), 30'000);
  ASSERT_EQ(once.size(), again.size());
  for (std::size_t level = 0; level < once.size(); ++level) EXPECT_EQ(once[level].tiles, again[level].tiles);
}

}  // namespace test_picture_tiles
}  // namespace tessera
