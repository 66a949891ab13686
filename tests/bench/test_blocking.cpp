// Silhouettes recognised by a part of their boundary: clipping, which answers count as found, and a whole run.
#include <gtest/gtest.h>

#include <algorithm>

#include "bench/benchmarks.h"
#include "bench/blocking/clipped_curves.h"
#include "bench/blocking/jpeg_copy.h"
#include "bench/blocking/known_silhouettes.h"
#include "bench/blocking/success.h"
#include "blocking_silhouettes.h"
#include "core/base/error.h"
#include "core/geometry/polygon.h"
#include "support/scratch_folder.h"

namespace tessera::bench {
namespace test_blocking {

/// A box of 100 x 60 px with its upper left corner at (20, 30).
cv::Mat box_mask() {
  cv::Mat mask(120, 160, CV_8U, cv::Scalar(0));
  mask(cv::Rect(20, 30, 100, 60)).setTo(255);
  return mask;
}

std::vector<Curve> clipped(const Clipping& clipping, const View& view = {}, std::uint64_t seed = 1) {
  Draws draws(seed);
  return clipped_curves(box_mask(), clipping, view, draws);
}

TEST(Clipping, NothingHiddenIsTheWholeBoundary) {
  const std::vector<Curve> curves = clipped({});
  ASSERT_EQ(curves.size(), 1u);
  EXPECT_TRUE(curves[0].closed);
  EXPECT_NEAR(signed_area(curves[0].points), 100 * 60, 20) << "interior on the left";
}

TEST(Clipping, ACountedEdgeIsBoundary) {
  const std::vector<Curve> curves = clipped({.blocked = 0.4, .edge_removed = false});
  ASSERT_EQ(curves.size(), 1u);
  EXPECT_TRUE(curves[0].closed);
  EXPECT_NEAR(signed_area(curves[0].points), 60 * 60, 20);
  EXPECT_NEAR(length_of(curves[0]), 4 * 60, 4);
}

TEST(Clipping, ARemovedEdgeLeavesAnArc) {
  for (const double turned_rad : {0., 1., 4.}) {
    for (const double size : {0.5, 1., 2.}) {
      const std::vector<Curve> curves = clipped({.blocked = 0.4}, {.turned_rad = turned_rad, .size = size});
      ASSERT_EQ(curves.size(), 1u);
      EXPECT_FALSE(curves[0].closed);
      EXPECT_NEAR(length_of(curves[0]), 180 * size, 15 * std::max(1., size)) << "three sides of 60 px, and stairs";
    }
  }
}

TEST(Clipping, WithoutAClipNothingIsRemoved) { EXPECT_TRUE(clipped({}, {.turned_rad = 1}).at(0).closed); }

TEST(Clipping, PartsOfAShapeAreCurvesOfTheirOwn) {
  cv::Mat mask = box_mask();
  mask(cv::Rect(60, 50, 60, 20)).setTo(0);  // a C that is open to the right
  Draws draws(1);
  EXPECT_EQ(clipped_curves(mask, {.blocked = 0.6}, {}, draws).size(), 2u);
}

TEST(Clipping, AHoleKeepsItsWholeBoundaryBesideTheClip) {
  cv::Mat mask = box_mask();
  mask(cv::Rect(90, 50, 20, 20)).setTo(0);
  Draws draws(1);
  const std::vector<Curve> curves = clipped_curves(mask, {.blocked = 0.4}, {}, draws);
  ASSERT_EQ(curves.size(), 2u);
  EXPECT_EQ(std::count_if(curves.begin(), curves.end(), [](const Curve& c) { return c.closed; }), 1);
}

TEST(Clipping, NothingIsLeftOfAnEmptyMask) {
  Draws draws(1);
  EXPECT_TRUE(clipped_curves(cv::Mat(20, 20, CV_8U, cv::Scalar(0)), {.blocked = 0.5}, {}, draws).empty());
}

TEST(Clipping, NoiseHasItsWidthAndItsSeed) {
  const std::vector<Curve> noisy = clipped({}, {.noise_px = 1.5});
  EXPECT_EQ(noisy, clipped({}, {.noise_px = 1.5}));
  EXPECT_NE(noisy, clipped({}, {.noise_px = 1.5}, 2));
  // The y of points along the two horizontal sides, measured from the nearer side.
  double squares = 0, count = 0;
  const Box box = bounding_box(clipped({}).at(0).points);
  for (const Vec2 p : noisy.at(0).points) {
    if (p.x < box.low.x + 10 || p.x > box.high.x - 10) continue;
    const double off = std::min(std::abs(p.y - box.low.y), std::abs(p.y - box.high.y));
    squares += off * off;
    ++count;
  }
  EXPECT_GT(count, 140);
  EXPECT_NEAR(std::sqrt(squares / count), 1.5, 0.3);
}

/// The number of pixels beside the mask's edges whose values JPEG changes.
int changed_pixels(int quality) {
  cv::Mat mask(64, 64, CV_8U, cv::Scalar(0));
  cv::circle(mask, {30, 33}, 20, 255, cv::FILLED);
  const cv::Mat copy = jpeg_copy(mask, quality);
  EXPECT_EQ(copy.size(), mask.size());
  EXPECT_EQ(copy.type(), CV_8U);
  EXPECT_EQ(cv::countNonZero((copy > 127) != mask) > 30, false) << "nearly the same mask";
  cv::Mat difference;
  cv::absdiff(mask, copy, difference);
  return cv::countNonZero(difference > 16);
}

TEST(JpegCopy, LosesMoreAtALowerQuality) {
  EXPECT_LT(changed_pixels(95), 40);
  EXPECT_GT(changed_pixels(20), 2 * changed_pixels(80));
}

TEST(JpegCopy, RefusesWhatIsTooLarge) {
  EXPECT_THROW(jpeg_copy(cv::Mat(1, 70000, CV_8U, cv::Scalar(0)), 90), InputError);
}

TEST(Clipping, AJpegMovesTheBoundaryALittle) {
  const std::vector<Curve> clean = clipped({}, {.turned_rad = 0.3});
  const std::vector<Curve> jpeg = clipped({}, {.turned_rad = 0.3, .jpeg_quality = 30});
  ASSERT_EQ(jpeg.size(), 1u);
  EXPECT_NE(jpeg, clean);
  EXPECT_NEAR(signed_area(jpeg[0].points), signed_area(clean[0].points), 100);
}

TEST(Silhouettes, TheLargestPartIsKept) {
  cv::Mat grey(50, 80, CV_8U, cv::Scalar(100));
  grey(cv::Rect(0, 0, 20, 20)).setTo(200);
  grey(cv::Rect(50, 30, 5, 5)).setTo(255);
  const cv::Mat mask = largest_part(grey);
  EXPECT_EQ(cv::countNonZero(mask), 400);
  EXPECT_GT(cv::boundingRect(mask).x, 0) << "clear pixels round it";
  EXPECT_TRUE(largest_part(cv::Mat(10, 10, CV_8U, cv::Scalar(127))).empty());
}

std::vector<Silhouette> named(const std::vector<std::string>& names) {
  std::vector<Silhouette> silhouettes;
  for (const std::string& name : names) silhouettes.push_back({name, {}});
  return silhouettes;
}

TEST(Twins, AreReadFromPairsOfNames) {
  const Twins twins("# made by hand\na b 0.98\n\nb c # near\nd d\na stranger\n", "t.txt", named({"a", "b", "c", "d"}));
  EXPECT_EQ(twins.size(), 2u);
  EXPECT_TRUE(twins.are_twins(0, 1) && twins.are_twins(1, 0) && twins.are_twins(2, 1) && twins.are_twins(3, 3));
  EXPECT_FALSE(twins.are_twins(0, 2)) << "a twin's twin is none";
  EXPECT_FALSE(twins.are_twins(0, 1, true) || twins.are_twins(3, 3, true))
      << "nor is a mirror image that is not listed";
}

TEST(Twins, MayBeMirrorImages) {
  const Twins twins("d ~a\nc ~c\n~a ~b\n", "t.txt", named({"a", "b", "c", "d"}));
  EXPECT_EQ(twins.size(), 3u);
  EXPECT_TRUE(twins.are_twins(0, 3, true) && twins.are_twins(3, 0, true));
  EXPECT_TRUE(twins.are_twins(2, 2, true)) << "a symmetric silhouette";
  EXPECT_TRUE(twins.are_twins(0, 1)) << "both mirrored: a pair like any other";
  EXPECT_FALSE(twins.are_twins(0, 3) || twins.are_twins(0, 1, true) || twins.are_twins(3, 3, true));
}

TEST(Twins, ALineOfOneNameIsRefused) {
  try {
    const Twins twins("a b\na\n", "t.txt", named({"a", "b"}));
    FAIL();
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(), "t.txt, line 2: found one name, \"a\"; needed: two names, which are twins");
  }
}

TEST(Success, CountsItselfAndTwins) {
  SilhouetteLibrary library;
  for (std::size_t i = 0; i < 6; ++i) library.shapes.push_back({.silhouette = i / 2, .mirrored = i % 2 == 1});
  const Twins twins("a b\nc ~c", "t.txt", named({"a", "b", "c"}));
  const Success itself = success_of({0, 5}, 0, library, twins);
  EXPECT_TRUE(itself.told && itself.itself && itself.twin && itself.among);
  const Success twin = success_of({2, 0}, 0, library, twins);
  EXPECT_TRUE(!twin.itself && twin.twin && twin.among);
  const Success mirrored = success_of({1, 2}, 0, library, twins);
  EXPECT_TRUE(mirrored.told && !mirrored.itself && !mirrored.twin && !mirrored.among);
  const Success symmetric = success_of({5}, 2, library, twins);
  EXPECT_TRUE(!symmetric.itself && symmetric.twin && !symmetric.among);
  EXPECT_FALSE(success_of({}, 0, library, twins).told);
}

/// The library holds the mirror image beside the silhouette, which stays.
TEST(Silhouettes, ALibraryHoldsTheirMirrorImages) {
  const std::vector<Silhouette> silhouettes = {{"blob", largest_part(test::blob_mask(3))}};
  const cv::Mat before = silhouettes[0].mask.clone();
  const SilhouetteLibrary library = make_silhouette_library(silhouettes, true);
  EXPECT_EQ(cv::countNonZero(before != silhouettes[0].mask), 0);
  ASSERT_EQ(library.shapes.size(), 2u);
  EXPECT_FALSE(library.shapes[0].mirrored);
  EXPECT_TRUE(library.shapes[1].mirrored);
  EXPECT_NEAR(bounding_box(library.shapes[0].outline).low.x, -bounding_box(library.shapes[1].outline).high.x, 0.02);
  EXPECT_EQ(make_silhouette_library(silhouettes, false).shapes.size(), 1u);
}

Setting quick_setting(const test::ScratchFolder& folder) {
  return {.quick = true, .devices = "all", .out = folder.path("blocking.json")};
}

TEST(Blocking, FindsBlobsByHalfOfThem) {
  const test::ScratchFolder folder;
  test::write_blobs(folder, 6);
  BlockingOptions options;
  options.shapes = folder.path("");
  options.mirrors = true;
  options.blocks = {0, 40};
  const Report report = bench_blocking(quick_setting(folder), options);
  EXPECT_EQ(report.json.at("benchmark"), "blocking");
  EXPECT_EQ(report.json.at("library_shapes"), 12);
  const Json& rows = report.json.at("rows");
  ASSERT_EQ(rows.size(), 2u);
  for (const Json& row : rows) {
    EXPECT_EQ(row.at("descriptor"), "pad");
    EXPECT_EQ(row.at("queries"), 6);
    EXPECT_GT(row.at("itself_percent").get<double>(), 80) << report.text;
    EXPECT_GT(row.at("query_s").get<double>(), 0);
  }
  for (const char* ending : {"svg", "png"}) {
    EXPECT_GT(std::filesystem::file_size(folder.path("blocking." + std::string(ending))), 100u);
  }
  Json again = bench_blocking(quick_setting(folder), options).json;
  for (std::size_t i = 0; i < 2; ++i) EXPECT_EQ(again["rows"][i]["twin_percent"], rows[i]["twin_percent"]);
}

/// All descriptors get the same queries and the same whole shapes, in the order of the command line.
TEST(Blocking, ComparesDescriptors) {
  const test::ScratchFolder folder;
  test::write_blobs(folder, 6);
  BlockingOptions options;
  options.shapes = folder.path("");
  options.blocks = {0};
  options.descriptors = {"hu-moments",         "pad", "shape-context", "triangle-areas", "curvature-scale-space",
                         "integral-invariants"};
  for (const bool scale_known : {true, false}) {
    options.scale_known = scale_known;
    const Report report = bench_blocking(quick_setting(folder), options);
    const Json& rows = report.json.at("rows");
    ASSERT_EQ(rows.size(), 6u);
    for (std::size_t i = 0; i < rows.size(); ++i) {
      EXPECT_EQ(rows[i].at("descriptor"), options.descriptors[i]);
      EXPECT_GT(rows[i].at("itself_percent").get<double>(), 80) << report.text;
    }
  }
}

std::string complaint(BlockingOptions options, const test::ScratchFolder& folder) {
  if (options.shapes.empty()) options.shapes = folder.path("");
  try {
    bench_blocking(quick_setting(folder), options);
  } catch (const InputError& error) {
    return error.what();
  }
  return "none";
}

TEST(Blocking, RefusesWhatItCannotDo) {
  const test::ScratchFolder folder;
  BlockingOptions options;
  options.shapes = folder.path("missing");
  EXPECT_NE(complaint(options, folder).find("--shapes: cannot read the folder"), std::string::npos);
  EXPECT_NE(complaint({}, folder).find("--shapes: found no PNG in"), std::string::npos);
  folder.write("a.png", "no picture");
  EXPECT_NE(complaint({}, folder).find("a.png: "), std::string::npos);
  test::write_png(folder.path("a.png"), cv::Mat(30, 30, CV_8U, cv::Scalar(0)));
  EXPECT_NE(complaint({}, folder).find("a.png: all is black"), std::string::npos);

  options = {};
  options.blocks = {0, 100};
  EXPECT_EQ(complaint(options, folder), "--blocks: found 100; allowed: 0 to 95 %");
  options.blocks = {-1};
  EXPECT_EQ(complaint(options, folder), "--blocks: found -1; allowed: 0 to 95 %");
  options = {};
  options.descriptors = {"pad", "sift"};
  EXPECT_EQ(complaint(options, folder),
            "--descriptors: found \"sift\"; allowed: pad, shape-context, triangle-areas, curvature-scale-space, "
            "integral-invariants, hu-moments");
  options = {};
  options.noise_px = std::nan("");
  EXPECT_EQ(complaint(options, folder), "--noise: found nan; allowed: 0 to 20 px");
  options = {};
  options.size = 0;
  EXPECT_EQ(complaint(options, folder), "--size: found 0; allowed: 0.0625 to 16");
  options = {};
  options.jpeg_quality = -1;
  EXPECT_EQ(complaint(options, folder), "--jpeg: found -1; allowed: 1 to 100, or 0 for none");
}

}  // namespace test_blocking
}  // namespace tessera::bench
