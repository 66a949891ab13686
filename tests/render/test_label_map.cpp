// labels.png: the piece of each pixel of the picture.
#include <gtest/gtest.h>
#include <sched.h>

#include "render/label_map.h"
#include "render/png_stream.h"
#include "support/drawn_collage.h"
#include "support/images.h"
#include "support/input_error.h"
#include "support/sample_collage.h"
#include "support/scratch_folder.h"

namespace tessera {
namespace test_label_map {

using test::SampleCollage;

cv::Mat labels_of(const CollageReport& report) {
  test::DrawnCollage drawn(report);
  cv::Mat whole;
  draw_labels(report, drawn.artworks, [&](const cv::Mat& rows) { whole.push_back(rows); });
  return whole;
}

/// A disc and a ring, at twice the canvas' px.
TEST(Labels, AreTheNumbersOfThePiecesFromOne) {
  const SampleCollage sample;
  const cv::Mat labels = labels_of(sample.report);
  ASSERT_EQ(labels.type(), CV_8UC1);
  ASSERT_EQ(labels.size(), cv::Size(400, 200));
  EXPECT_EQ(labels.at<std::uint8_t>(100, 100), 1);
  EXPECT_EQ(labels.at<std::uint8_t>(45, 280), 2);
  EXPECT_EQ(labels.at<std::uint8_t>(100, 280), 0) << "the hole of the ring";
  EXPECT_EQ(labels.at<std::uint8_t>(5, 5), 0);
  // A disc of size 40 px has the area of a square of 80 px in the picture.
  EXPECT_NEAR(cv::countNonZero(labels == 1), 80 * 80, 60);
  EXPECT_EQ(cv::countNonZero(labels > 2), 0) << "no shades at the edges";
}

TEST(Labels, OfPiecesOnEachOtherAreThoseOfTheUpperOnes) {
  SampleCollage sample;
  sample.place(ShapeId{7}, 20, {50, 50}, 0);
  const cv::Mat labels = labels_of(sample.report);
  EXPECT_EQ(labels.at<std::uint8_t>(100, 100), 3);
  EXPECT_EQ(labels.at<std::uint8_t>(100, 70), 1);
}

TEST(Labels, OfAPieceAcrossASeamAreAtBothEnds) {
  SampleCollage sample;
  sample.canvas = make_seamless_canvas(200, 100, true, true);
  sample.report.placements.clear();
  sample.place(ShapeId{7}, 40, {2, 50}, 0);
  const cv::Mat labels = labels_of(sample.report);
  EXPECT_EQ(labels.at<std::uint8_t>(100, 0), 1);
  EXPECT_EQ(labels.at<std::uint8_t>(100, 399), 1);
  EXPECT_NEAR(cv::countNonZero(labels), 80 * 80, 60);
}

TEST(Labels, HaveAsManyBitsAsTheyNeed) {
  SampleCollage sample;
  while (sample.report.placements.size() < 255) sample.place(ShapeId{7}, 4, {20, 20}, 0);
  EXPECT_EQ(labels_of(sample.report).type(), CV_8UC1);
  EXPECT_EQ(label_format(sample.report).grey_bits, 8);
  sample.place(ShapeId{7}, 4, {180, 90}, 0);
  const cv::Mat labels = labels_of(sample.report);
  ASSERT_EQ(labels.type(), CV_16UC1);
  EXPECT_EQ(labels.at<std::uint16_t>(180, 360), 256);
  EXPECT_EQ(labels.at<std::uint16_t>(40, 40), 255);
}

TEST(Labels, OfMorePiecesThanThereAreNumbersAreAnError) {
  SampleCollage sample;
  sample.report.placements.resize(65535, sample.report.placements[0]);
  EXPECT_EQ(label_format(sample.report).grey_bits, 16);
  sample.report.placements.resize(65536, sample.report.placements[0]);
  EXPECT_EQ(
      test::message_of([&] { label_format(sample.report); }).find("output.labels: found 65536 pieces, allowed: 65535"),
      0u);
}

TEST(Labels, AreThoseOfTheFile) {
  for (const std::size_t pieces : {2u, 300u}) {
    const test::ScratchFolder folder;
    SampleCollage sample;
    sample.report.output.width_px = 2000;  // gives more than one band
    while (sample.report.placements.size() < pieces) {
      const float i = float(sample.report.placements.size());
      sample.place(ShapeId{7}, 8, {4 + 0.64f * i, 4 + 0.3f * i}, 0);
    }
    test::DrawnCollage drawn(sample.report);
    PngStream png(folder.path("labels.png"), label_format(sample.report));
    std::size_t rows = 0;
    write_labels(sample.report, drawn.artworks, png, drawn.stop, [&](std::size_t done) { rows = done; });
    EXPECT_EQ(rows, 1000u);
    const cv::Mat read = test::read_image(folder.path("labels.png"));
    EXPECT_EQ(read.type(), pieces == 2 ? CV_8UC1 : CV_16UC1);
    EXPECT_EQ(cv::norm(read, labels_of(sample.report), cv::NORM_INF), 0) << pieces;
  }
}

/// Another number of threads takes the strips in another order.
TEST(Labels, DoNotDependOnTheThreads) {
  SampleCollage sample;
  sample.report.output.width_px = 1500;
  const cv::Mat labels = labels_of(sample.report);
  cpu_set_t before, one;
  sched_getaffinity(0, sizeof before, &before);
  CPU_ZERO(&one);
  for (int cpu = 0; cpu < CPU_SETSIZE && CPU_COUNT(&one) == 0; ++cpu) {
    if (CPU_ISSET(cpu, &before)) CPU_SET(cpu, &one);
  }
  sched_setaffinity(0, sizeof one, &one);
  EXPECT_EQ(cv::norm(labels_of(sample.report), labels, cv::NORM_INF), 0);
  sched_setaffinity(0, sizeof before, &before);
}

}  // namespace test_label_map
}  // namespace tessera
