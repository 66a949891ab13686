// Patches of colour over pieces: the same in pixels and in the image of an SVG.
#include "layers/tone_patch.h"

#include <gtest/gtest.h>

#include "layers/affine.h"

namespace tessera {
namespace test_tone_patch {

/// A patch that is red on the left and green on the right, a quarter opaque each.
TonePatch red_and_green() {
  TonePatch patch;
  for (int i = 0; i < kColourCells; ++i) {
    patch.bgra[std::size_t(i)] = i % kColourSide < 2 ? cv::Vec4b(0, 0, 255, 64) : cv::Vec4b(0, 255, 0, 64);
  }
  patch.canvas_from_cells = {10, 0, 100, 0, 10, 200};
  return patch;
}

cv::Mat tile(int width, int height, const cv::Vec4b& bgra) { return cv::Mat(height, width, CV_8UC4, cv::Scalar(bgra)); }

TEST(TonePatch, WithoutOpacityIsEmpty) {
  EXPECT_TRUE(TonePatch{}.empty());
  EXPECT_FALSE(red_and_green().empty());
  cv::Mat bgra = tile(4, 4, {10, 20, 30, 200});
  lay_patch({}, {0, 0}, 1, bgra);
  EXPECT_EQ(bgra.at<cv::Vec4b>(2, 2), cv::Vec4b(10, 20, 30, 200));
}

TEST(TonePatch, IsMixedWithWhatLiesBelow) {
  cv::Mat bgra = tile(80, 80, {200, 200, 200, 255});
  lay_patch(red_and_green(), {200, 400}, 2, bgra);
  const int mixed = 150, brighter = 214;  // 200 mixed with a quarter of 0 or 255
  const auto near = [](const cv::Vec4b& pixel, int blue, int green, int red) {
    return std::abs(pixel[0] - blue) <= 1 && std::abs(pixel[1] - green) <= 1 && std::abs(pixel[2] - red) <= 1;
  };
  EXPECT_TRUE(near(bgra.at<cv::Vec4b>(40, 2), mixed, mixed, brighter)) << bgra.at<cv::Vec4b>(40, 2);
  EXPECT_TRUE(near(bgra.at<cv::Vec4b>(40, 77), mixed, brighter, mixed)) << bgra.at<cv::Vec4b>(40, 77);
  EXPECT_TRUE(near(bgra.at<cv::Vec4b>(40, 40), mixed, 183, 181)) << "half way " << bgra.at<cv::Vec4b>(40, 40);
}

TEST(TonePatch, LeavesTransparencyAlone) {
  cv::Mat bgra = tile(80, 80, {0, 0, 0, 0});
  bgra.at<cv::Vec4b>(40, 2) = {50, 50, 50, 100};
  lay_patch(red_and_green(), {200, 400}, 2, bgra);
  EXPECT_EQ(bgra.at<cv::Vec4b>(40, 3), cv::Vec4b(0, 0, 0, 0));
  const cv::Vec4b pixel = bgra.at<cv::Vec4b>(40, 2);
  EXPECT_EQ(pixel[3], 100);
  EXPECT_NEAR(pixel[0], 37, 1);
  EXPECT_NEAR(pixel[2], 63, 1) << "37 and a quarter of 100";
}

/// Rows do not depend on the place where a tile begins.
TEST(TonePatch, IsTheSameInAnyTile) {
  TonePatch patch = red_and_green();
  patch.canvas_from_cells = {7, -4, 120, 4, 7, 190};
  cv::Mat whole = tile(80, 80, {90, 120, 200, 255});
  lay_patch(patch, {200, 400}, 1.7, whole);
  cv::Mat part = tile(80, 30, {90, 120, 200, 255});
  lay_patch(patch, {200, 450}, 1.7, part);
  EXPECT_EQ(cv::norm(part, whole.rowRange(50, 80), cv::NORM_INF), 0);
}

TEST(TonePatch, AsAPictureHasARing) {
  const cv::Mat picture = patch_picture(red_and_green());
  ASSERT_EQ(picture.size(), cv::Size(8, 8));
  EXPECT_EQ(picture.at<cv::Vec4b>(0, 0), cv::Vec4b(0, 0, 255, 64));
  EXPECT_EQ(picture.at<cv::Vec4b>(7, 7), cv::Vec4b(0, 255, 0, 64));
  EXPECT_EQ(picture.at<cv::Vec4b>(4, 3), cv::Vec4b(0, 0, 255, 64));
  EXPECT_EQ(picture.at<cv::Vec4b>(4, 4), cv::Vec4b(0, 255, 0, 64));
  const cv::Vec2d corner = canvas_from_patch_picture(red_and_green()) * cv::Vec3d(2, 2, 1);
  EXPECT_EQ(corner, cv::Vec2d(100, 200));
}

TEST(Affine, InverseAndJoined) {
  const cv::Matx23d m = {3, -2, 7, 1, 4, -5};
  const cv::Matx23d one = joined(inverse(m), m);
  EXPECT_LT(cv::norm(one - cv::Matx23d(1, 0, 0, 0, 1, 0)), 1e-12);
  const cv::Vec2d by_parts =
      m * cv::Vec3d((inverse(m) * cv::Vec3d(2, 3, 1))[0], (inverse(m) * cv::Vec3d(2, 3, 1))[1], 1);
  EXPECT_LT(cv::norm(by_parts - cv::Vec2d(2, 3)), 1e-12);
}

}  // namespace test_tone_patch
}  // namespace tessera
