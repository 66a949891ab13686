// Drawing in separate processes: the results that come back, and bad drawings that cost only themselves.
#include <glib.h>
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <chrono>
#include <cmath>
#include <future>
#include <thread>

#include "artwork/artwork_render.h"
#include "artwork/protocol/shape_codec.h"
#include "artwork/svg/svg_import.h"
#include "artwork/warping/warped_svg.h"
#include "drawer_samples.h"

namespace tessera {
namespace test_drawers {

using namespace std::chrono_literals;
using test::Bytes;
using test::disc_with_alpha;
using test::encoded;
using test::equal;
using test::kDisc;
using test::kTwo;
using test::mistake;
using test::svg;

/// A drawing that aborts librsvg 2.54.
Bytes panicking_svg() {
  std::string matrix;
  for (int i = 0; i < 100 * 100; ++i) matrix += "1 ";
  return svg("<filter id=\"f\"><feConvolveMatrix order=\"100\" kernelMatrix=\"" + matrix +
             "\"/></filter><circle cx=\"30\" cy=\"25\" r=\"20\" filter=\"url(#f)\"/>");
}

/// A drawing that takes librsvg minutes.
Bytes slow_svg() {
  std::string blurs;
  for (int i = 0; i < 20000; ++i) blurs += "<feGaussianBlur stdDeviation=\"50\"/>";
  return svg("<filter id=\"f\">" + blurs + "</filter><circle cx=\"30\" cy=\"25\" r=\"20\" filter=\"url(#f)\"/>");
}

void expect_no_children() {
  EXPECT_EQ(::waitpid(-1, nullptr, WNOHANG), -1);
  EXPECT_EQ(errno, ECHILD);
}

TEST(Drawers, DrawWhatIsDrawnInOneProcess) {
  Drawers drawers(kTwo);
  for (const Bytes& bytes : {svg(kDisc), encoded(disc_with_alpha(), ".png"), encoded(disc_with_alpha(), ".webp")}) {
    EXPECT_TRUE(equal(drawers.render(bytes, "a", 301), render_artwork(bytes, "a", 301)));
  }
}

TEST(Drawers, ImportWhatIsImportedInOneProcess) {
  Drawers drawers(kTwo);
  EXPECT_EQ(drawers.natural_size(svg(kDisc), "a"), cv::Size2d(100, 50));
  EXPECT_EQ(drawers.natural_size(encoded(disc_with_alpha(), ".png"), "a"), cv::Size2d(300, 200));
  EXPECT_EQ(drawers.import_svg(svg(kDisc), "a", "s7"), import_svg(svg(kDisc), "a", "s7", {100, 50}));
}

Warp any_warp() {
  Warp warp{.origin = {-5, -5}, .step = 5, .displacement = {23, 13}, .active = {22, 12, 1}, .falling = false};
  for (int i = 0; i < 23; ++i) warp.displacement(i, 6) = {1.5f, -0.5f};
  warp.active(3, 3) = 0;
  return warp;
}

TEST(Drawers, DeformWhatIsDeformedInOneProcess) {
  Drawers drawers(kTwo);
  EXPECT_EQ(drawers.warped_svg(svg(kDisc), "a", "s7", any_warp()), warped_svg(svg(kDisc), "a", "s7", any_warp()));
  EXPECT_THROW(drawers.warped_svg(encoded(disc_with_alpha(), ".png"), "a", "s7", any_warp()), InputError);
  Warp torn = any_warp();
  torn.displacement(1, 1).x = std::nanf("");
  EXPECT_THROW(drawers.warped_svg(svg(kDisc), "a", "s7", torn), InputError);
}

TEST(Drawers, TraceWhatIsTracedInOneProcess) {
  Drawers drawers(kTwo);
  for (const TracingSettings& settings : {TracingSettings{}, {{3, 0.25f}, 0.5f}, {{}, 0.1f}}) {
    const auto traced = drawers.shape(svg(kDisc), "/some/disc.svg", settings);
    const auto expected = shape_from_artwork(svg(kDisc), "/some/disc.svg", settings);
    EXPECT_EQ(encode_shape(std::get<ArtworkShape>(traced).shape), encode_shape(std::get<ArtworkShape>(expected).shape));
  }
  EXPECT_EQ(std::get<SkipReason>(drawers.shape(svg(""), "empty.svg", {})), SkipReason::empty);
}

TEST(Drawers, DecodePngsAsTheyAre) {
  Drawers drawers(kTwo);
  const cv::Mat grey(40, 60, CV_8UC1, cv::Scalar(99));
  const cv::Mat small = drawers.decode_png(encoded(grey, ".png"), "a", 100);
  EXPECT_EQ(small.size(), cv::Size(60, 40));
  EXPECT_EQ(small.at<cv::Vec4b>(20, 30), cv::Vec4b(99, 99, 99, 255));
  EXPECT_EQ(drawers.decode_png(encoded(disc_with_alpha(), ".png"), "a", 150).size(), cv::Size(150, 100));
  EXPECT_TRUE(equal(drawers.decode_png(encoded(disc_with_alpha(), ".png"), "a", 300), disc_with_alpha()));
  EXPECT_THROW(drawers.decode_png(svg(kDisc), "a", 100), InputError);
}

TEST(Drawers, MakePdfsWithoutTimeStamps) {
  Drawers drawers(kTwo);
  const Bytes pdf = drawers.pdf_of_svg(svg(kDisc), 200);
  const std::string text(pdf.begin(), pdf.end());
  EXPECT_TRUE(text.starts_with("%PDF-"));
  EXPECT_NE(text.find("/MediaBox [ 0 0 200 100 ]"), std::string::npos);
  EXPECT_EQ(text.find("CreationDate"), std::string::npos);
  EXPECT_EQ(pdf, drawers.pdf_of_svg(svg(kDisc), 200));
  EXPECT_THROW(drawers.pdf_of_svg(Bytes(10, 'x'), 200), InputError);
}

TEST(Drawers, APdfThatCannotBeMadePieceByPieceIsMadeAsAWhole) {
  Drawers drawers(kTwo);
  const std::string odd =
      "<g id=\"layer-pieces\"><g id=\"piece-0-a\" transform=\"scale(2)\">" + std::string(kDisc) + "</g></g>";
  const Bytes pdf = drawers.pdf_of_svg(svg(odd), 200);
  EXPECT_TRUE(std::string(pdf.begin(), pdf.end()).starts_with("%PDF-"));
}

TEST(Drawers, NameTheFileAndTheReason) {
  Drawers drawers(kTwo);
  EXPECT_TRUE(mistake(drawers, Bytes(1000, '<')).starts_with("some/file.svg: not a readable SVG file"));
  EXPECT_TRUE(mistake(drawers, {}).starts_with("some/file.svg: neither SVG nor"));
  EXPECT_NE(mistake(drawers, svg(kDisc), 0).find("allowed are 1 to"), std::string::npos);
}

TEST(Drawers, APanicCostsItsOwnDrawing) {
  Drawers drawers(kTwo);
  EXPECT_NO_THROW(drawers.render(svg(kDisc), "a", 100));
  EXPECT_EQ(mistake(drawers, panicking_svg()), std::string("some/file.svg: ") + test::kPanicReason);
  EXPECT_NO_THROW(drawers.render(svg(kDisc), "a", 100));
}

/// An image of 10,000 x 10,000 px in 10 kB. librsvg leaves out parts that do not fit into memory.
TEST(Drawers, WhatNeedsTooMuchMemoryIsTold) {
#ifdef __SANITIZE_ADDRESS__
  GTEST_SKIP() << "the sanitizer has an allocator of its own";
#endif
  const Bytes png = encoded(cv::Mat(10000, 10000, CV_8UC1, cv::Scalar(0)), ".png");
  gchar* base64 = g_base64_encode(png.data(), png.size());
  const Bytes bomb =
      svg(std::string("<image width=\"100\" height=\"50\" xlink:href=\"data:image/png;base64,") + base64 + "\"/>");
  g_free(base64);
  Drawers drawers(kTwo);
  EXPECT_NO_THROW(drawers.render(svg(kDisc), "a", 100));
  EXPECT_EQ(mistake(drawers, bomb), "some/file.svg: needs more than 256 MiB of memory");
  EXPECT_EQ(mistake(drawers, svg(kDisc, R"(width="99" height="99")"), kMaxArtworkSide_px),
            "some/file.svg: needs more than 256 MiB of memory");
  EXPECT_NO_THROW(drawers.render(svg(kDisc), "a", 100));
}

TEST(Drawers, WhatTakesTooLongIsEnded) {
  DrawerSettings settings = kTwo;
  settings.seconds_per_drawing = 0.5;
  Drawers drawers(settings);
  const auto start = std::chrono::steady_clock::now();
  EXPECT_EQ(mistake(drawers, slow_svg()), "some/file.svg: took longer than 0.5 s");
  EXPECT_LT(std::chrono::steady_clock::now() - start, 5s);
  EXPECT_NO_THROW(drawers.render(svg(kDisc), "a", 100));
}

TEST(Drawers, ServeSeveralThreads) {
  Drawers drawers(kTwo);
  std::vector<std::future<cv::Mat>> drawings;
  for (int i = 0; i < 12; ++i) {
    drawings.push_back(std::async(std::launch::async, [&, i] { return drawers.render(svg(kDisc), "a", 100 + i); }));
  }
  for (int i = 0; i < 12; ++i) EXPECT_EQ(drawings[std::size_t(i)].get().cols, 100 + i);
}

TEST(Drawers, StopEndsWhatIsUnderWay) {
  Drawers drawers(kTwo);
  auto drawing = std::async(std::launch::async, [&] { drawers.render(slow_svg(), "a", 300); });
  auto waiting = std::async(std::launch::async, [&] { drawers.render(slow_svg(), "a", 300); });
  std::this_thread::sleep_for(300ms);
  const auto start = std::chrono::steady_clock::now();
  drawers.stop();
  EXPECT_THROW(drawing.get(), DrawingStopped);
  EXPECT_THROW(waiting.get(), DrawingStopped);
  EXPECT_THROW(drawers.render(svg(kDisc), "a", 100), DrawingStopped);
  EXPECT_LT(std::chrono::steady_clock::now() - start, 1s);
}

TEST(Drawers, LeaveNoProcessBehind) {
  { Drawers(kTwo).render(svg(kDisc), "a", 100); }
  expect_no_children();
}

}  // namespace test_drawers
}  // namespace tessera
