// Statistics of drawn pictures whose elements are known.
#include "texture_statistics.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <vector>

namespace tessera::bench {
namespace test_texture_statistics {

/// Bricks of 60 x 30 px with joints of 6 px; the picture's edge cuts no brick.
cv::Mat wall() {
  cv::Mat labels = cv::Mat::zeros(8 * 36 + 6, 5 * 66 + 39, CV_32S);
  int count = 0;
  for (int row = 0; row < 8; ++row) {
    for (int i = 0; i < 5; ++i) labels(cv::Rect(6 + i * 66 + row % 2 * 30, 6 + row * 36, 60, 30)) = ++count;
  }
  return labels;
}

TextureStatistics statistics_of(const cv::Mat& labels) {
  cv::Mat grey, bgr;
  cv::Mat(labels > 0).convertTo(grey, CV_8U, 0.5, 50);
  cv::cvtColor(grey, bgr, cv::COLOR_GRAY2BGR);
  TextureStatistics statistics;
  add_picture(bgr, LabelRuns(labels), statistics);
  return statistics;
}

/// One bar in the middle of a picture, turned clockwise.
cv::Mat bar(double angle_deg) {
  cv::Mat labels = cv::Mat::zeros(200, 200, CV_32S);
  cv::Point2f corners[4];
  cv::RotatedRect({100, 100}, {120, 30}, float(angle_deg)).points(corners);
  const std::vector<cv::Point> polygon(corners, corners + 4);
  cv::fillConvexPoly(labels, polygon, cv::Scalar(1));
  return labels;
}

cv::Mat noise(double deviation) {
  cv::RNG random(3);
  cv::Mat grey(256, 300, CV_8U), bgr;
  random.fill(grey, cv::RNG::NORMAL, 128, deviation);
  cv::cvtColor(grey, bgr, cv::COLOR_GRAY2BGR);
  return bgr;
}

TEST(TextureStatistics, OfAWallOfKnownBricks) {
  const TextureStatistics wall_statistics = statistics_of(wall());
  ASSERT_EQ(wall_statistics.sizes_px.size(), 40U);
  for (const double size_px : wall_statistics.sizes_px) EXPECT_NEAR(size_px, std::sqrt(1800), 1e-9);
  for (const double elongation : wall_statistics.elongations) EXPECT_NEAR(elongation, 0.5, 1e-6);
  ASSERT_EQ(wall_statistics.angles_rad.size(), 40U);
  for (const double angle_rad : wall_statistics.angles_rad) EXPECT_NEAR(angle_rad, 0, 1e-9);
  ASSERT_EQ(wall_statistics.pitches_px.size(), 1U);
  EXPECT_NEAR(wall_statistics.pitches_px[0], 36, 0.2);
  ASSERT_EQ(wall_statistics.pictures(), 1U);
  EXPECT_NEAR(wall_statistics.covered[0], 40 * 1800. / double(wall().total()), 1e-9);
}

TEST(TextureStatistics, JointsOfAWallWithBricksOnAllSides) {
  const TextureStatistics inner = statistics_of(wall().rowRange(20, 270).clone());
  ASSERT_EQ(inner.joints_px.size(), 30U);
  for (const double joint_px : inner.joints_px) EXPECT_NEAR(joint_px, 6, 0.1);
}

TEST(TextureStatistics, CutElementsCountOnlyAsCovered) {
  const cv::Mat labels = wall();
  // The left edge cuts each second brick in the first column in half, and the right edge touches no brick.
  const cv::Mat part = labels.colRange(36, labels.cols).clone();
  const TextureStatistics cut = statistics_of(part);
  EXPECT_EQ(cut.sizes_px.size(), 32U);
  EXPECT_NEAR(cut.covered[0], cv::countNonZero(part) / double(part.total()), 1e-9);
}

TEST(TextureStatistics, OneElementIsFarFromAllOthersAndHasTheAngleOfItsMajorAxis) {
  for (const double angle_deg : {20., 70., 110., 160.}) {
    const TextureStatistics of_bar = statistics_of(bar(angle_deg));
    ASSERT_EQ(of_bar.angles_rad.size(), 1U);
    EXPECT_NEAR(of_bar.angles_rad[0], angle_deg * CV_PI / 180, 0.02);
    EXPECT_NEAR(of_bar.elongations[0], 0.25, 0.02);
    EXPECT_GT(of_bar.joints_px[0], 60) << "the longer side of its box";
    EXPECT_TRUE(of_bar.pitches_px.empty());
  }
}

TEST(TextureStatistics, AngleOfARoundElementIsNotCounted) {
  cv::Mat labels = cv::Mat::zeros(100, 100, CV_32S);
  cv::circle(labels, {50, 50}, 20, 1, cv::FILLED);
  const TextureStatistics of_disc = statistics_of(labels);
  EXPECT_NEAR(of_disc.elongations.at(0), 1, 1e-6);
  EXPECT_TRUE(of_disc.angles_rad.empty());
}

TEST(TextureStatistics, APictureWithoutElements) {
  const TextureStatistics none = statistics_of(cv::Mat::zeros(64, 64, CV_32S));
  EXPECT_TRUE(none.sizes_px.empty());
  EXPECT_EQ(none.covered, std::vector<double>{0});
  const TextureDistances distances = texture_distances(statistics_of(wall()), none);
  EXPECT_FALSE(distances.sizes);
  EXPECT_FALSE(distances.angles);
  EXPECT_FALSE(distances.pitch_ratio);
}

TEST(TextureStatistics, SpectrumOfNoiseIsFlatAndItsPowerIsTheVariance) {
  const std::vector<double> spectrum_db = luminance_spectrum_db(noise(10));
  ASSERT_EQ(spectrum_db.size(), 15U) << "from a half down to four cycles in 256 px: five octaves";
  for (const double power_db : spectrum_db) EXPECT_NEAR(power_db, 20, 1.5);
  EXPECT_NEAR(spectrum_db[0], 20, 0.1);
}

TEST(TextureStatistics, SpectrumOfAWavePeaksInItsBand) {
  cv::Mat bgr(256, 256, CV_8UC3);
  for (int x = 0; x < bgr.cols; ++x) bgr.col(x) = cv::Scalar::all(128 + 100 * std::sin(2 * CV_PI * x / 9));
  const std::vector<double> spectrum_db = luminance_spectrum_db(bgr);
  // 1/9 cycle a px is 2.17 octaves below a half.
  EXPECT_EQ(std::max_element(spectrum_db.begin(), spectrum_db.end()) - spectrum_db.begin(), 6);
  // The window keeps the wave out of bands that are far below it.
  for (std::size_t band = 10; band < spectrum_db.size(); ++band) EXPECT_LT(spectrum_db[band], spectrum_db[6] - 70);
}

TEST(TextureDistances, AreNoneToItself) {
  const TextureStatistics statistics = statistics_of(wall());
  const TextureDistances distances = texture_distances(statistics, statistics);
  EXPECT_EQ(distances.sizes, 0);
  EXPECT_EQ(distances.elongations, 0);
  EXPECT_EQ(distances.angles, 0);
  EXPECT_EQ(distances.joints, 0);
  EXPECT_EQ(distances.pitch_ratio, 1);
  EXPECT_EQ(distances.covered, 0);
  EXPECT_EQ(distances.spectrum_db, 0);
}

TEST(TextureDistances, OfAnEnlargedWall) {
  cv::Mat twice;
  cv::resize(wall(), twice, {}, 2, 2, cv::INTER_NEAREST);
  const TextureDistances distances = texture_distances(statistics_of(wall()), statistics_of(twice));
  EXPECT_EQ(distances.sizes, 1);
  EXPECT_GT(distances.joints, 0.9) << "at the corners of the wall, joints are wider";
  EXPECT_NEAR(*distances.pitch_ratio, 2, 0.02);
  EXPECT_NEAR(*distances.covered, 0, 1e-9);
}

TEST(TextureDistances, OfHalfTheContrastIsSixDecibels) {
  TextureStatistics strong, weak;
  strong.spectra_db.push_back(luminance_spectrum_db(noise(40)));
  weak.spectra_db.push_back(luminance_spectrum_db(noise(20)));
  EXPECT_NEAR(*texture_distances(strong, weak).spectrum_db, 6.02, 0.1);
}

TEST(SampleDistances, AsByHand) {
  EXPECT_DOUBLE_EQ(*kolmogorov_smirnov_distance({1, 2, 3, 4}, {3, 4, 5, 6}), 0.5);
  EXPECT_DOUBLE_EQ(*kolmogorov_smirnov_distance({4, 1, 3, 2}, {2, 2, 2}), 0.5);
  EXPECT_FALSE(kolmogorov_smirnov_distance({}, {1}));
  EXPECT_FALSE(kuiper_distance({1}, {}));
  // Above by 0.5 at 1, below by 0.25 at 2.
  EXPECT_DOUBLE_EQ(*kuiper_distance({1, 1, 3, 3}, {2, 2, 2, 4}), 0.75);
}

TEST(SampleDistances, ByChance) {
  // The tables of the two-sample test for two samples of 100.
  EXPECT_NEAR(*kolmogorov_smirnov_by_chance(100, 100), 0.192, 0.001);
  EXPECT_NEAR(*kuiper_by_chance(100, 100), 0.247, 0.001);
  EXPECT_FALSE(kuiper_by_chance(0, 5));
  cv::RNG random(9);
  int beyond = 0;
  for (int trial = 0; trial < 400; ++trial) {
    std::vector<double> a, b;
    for (int i = 0; i < 200; ++i) (i < 80 ? a : b).push_back(random.uniform(0., 1.));
    beyond += *kuiper_distance(a, b) > *kuiper_by_chance(a.size(), b.size());
  }
  EXPECT_NEAR(beyond, 20, 15) << "one in twenty, of 400";
}

TEST(SampleDistances, OfKuiperDoesNotDependOnTheBeginOfTheCircle) {
  const auto turned = [](std::vector<double> values, double by) {
    for (double& value : values) value = std::fmod(value + by, 1.);
    return values;
  };
  const std::vector<double> a = {0.05, 0.1, 0.2, 0.7, 0.95}, b = {0.15, 0.3, 0.4, 0.6, 0.8, 0.9};
  for (const double by : {0.12, 0.5, 0.83})
    EXPECT_NEAR(*kuiper_distance(turned(a, by), turned(b, by)), *kuiper_distance(a, b), 1e-12);
}

}  // namespace test_texture_statistics
}  // namespace tessera::bench
