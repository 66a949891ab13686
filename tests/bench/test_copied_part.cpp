// The part of a picture that comes again at another place.
#include <gtest/gtest.h>

#include <opencv2/imgproc.hpp>

#include "copied_part.h"

namespace tessera::bench {
namespace test_copied_part {

/// Soft random spots.
cv::Mat spots(cv::Size size, int seed) {
  cv::RNG random(seed);
  cv::Mat picture(size, CV_8UC3);
  random.fill(picture, cv::RNG::UNIFORM, 0, 255);
  cv::GaussianBlur(picture, picture, {}, 2);
  cv::normalize(picture, picture, 0, 255, cv::NORM_MINMAX);
  return picture;
}

TEST(CopiedPart, IsNothingWhereAllDiffers) { EXPECT_EQ(copied_part(spots({200, 150}, 1), 20), 0); }

TEST(CopiedPart, IsAllOfAPictureThatIsThereTwice) {
  const cv::Mat once = spots({100, 100}, 2);
  cv::Mat twice;
  cv::hconcat(once, once, twice);
  EXPECT_GT(copied_part(twice, 20), 0.9);  // not where the copies meet
}

TEST(CopiedPart, IsThePartThatWasCopied) {
  cv::Mat picture = spots({200, 200}, 3);
  picture(cv::Rect(0, 0, 100, 50)).copyTo(picture(cv::Rect(100, 150, 100, 50)));
  EXPECT_NEAR(copied_part(picture, 20), 0.2, 0.08);
}

TEST(CopiedPart, IsNothingOfASmallPicture) { EXPECT_EQ(copied_part(spots({30, 30}, 4), 20), 0); }

}  // namespace test_copied_part
}  // namespace tessera::bench
