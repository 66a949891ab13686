// Recognition in the public library, among outlines and among a library's shapes; and bad input.
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cmath>
#include <set>

#include "core/shape/shape_builder.h"
#include "library/storage/library_file.h"
#include "sample_outlines.h"
#include "support/scratch_folder.h"

namespace tessera {
namespace test_package_recognise {

using matching::KnownOutlines;
using matching::Outline;
using matching::Recognised;
using test::error_of;

std::vector<Outline> random_outlines(int count) {
  std::vector<Outline> outlines;
  for (int i = 0; i < count; ++i) outlines.push_back(test::random_outline(std::uint32_t(i)));
  return outlines;
}

/// The first half of the outline.
Outline half(Outline outline) {
  outline.curves[0].closed = false;
  outline.curves[0].points.resize(outline.curves[0].points.size() / 2);
  return outline;
}

TEST(PackageRecognise, AWholeAndAHalf) {
  const std::vector<Outline> outlines = random_outlines(12);
  const KnownOutlines known(outlines);
  ASSERT_EQ(known.size(), 12u);
  const matching::Similarity query_from_known = test::similarity(250, 2, 4e4, 1e5);
  for (const Outline& seen : {outlines[5], half(outlines[5])}) {
    const std::vector<Recognised> found = known.recognise(test::mapped(seen, query_from_known), {.most = 3});
    ASSERT_GE(found.size(), 1u);
    EXPECT_LE(found.size(), 3u);
    EXPECT_EQ(found[0].known, 5u);
    EXPECT_GT(found[0].similarity, 0.8);
    EXPECT_NEAR(found[0].query_from_known.scale(), 250, 3);
    const matching::Point at = found[0].query_from_known.apply({1, 0}), expected = query_from_known.apply({1, 0});
    EXPECT_NEAR(at.x, expected.x, 5);
    EXPECT_NEAR(at.y, expected.y, 5);
  }
}

TEST(PackageRecognise, AnOpenCurveMayRunEitherWay) {
  const std::vector<Outline> outlines = random_outlines(6);
  const KnownOutlines known(outlines);
  Outline query = half(outlines[4]);
  const double forwards = known.recognise(query, {.most = 1}).at(0).similarity;
  std::reverse(query.curves[0].points.begin(), query.curves[0].points.end());
  const std::vector<Recognised> found = known.recognise(query, {.most = 6});
  ASSERT_FALSE(found.empty());
  EXPECT_EQ(found[0].known, 4u);
  EXPECT_NEAR(found[0].similarity, forwards, 0.02);
  std::set<std::size_t> each;
  for (const Recognised& r : found) EXPECT_TRUE(each.insert(r.known).second) << "told twice: " << r.known;
}

TEST(PackageRecognise, TheScoreCountsBothLengths) {
  const std::vector<Outline> outlines = random_outlines(6);
  const KnownOutlines known(outlines);
  EXPECT_NEAR(known.recognise(outlines[1], {.most = 1}).at(0).score, 1, 0.05);
  const Recognised of_half = known.recognise(half(outlines[1]), {.most = 1}).at(0);
  EXPECT_EQ(of_half.known, 1u);
  EXPECT_NEAR(of_half.score, std::sqrt(0.5), 0.1);
}

TEST(PackageRecognise, AKnownScaleExcludesOthers) {
  const std::vector<Outline> outlines = random_outlines(4);
  const KnownOutlines known(outlines);
  const Outline query = test::mapped(outlines[2], test::similarity(7, 1, 0, 0));
  EXPECT_EQ(known.recognise(query, {.most = 1, .scale = 7}).at(0).known, 2u);
  const std::vector<Recognised> other = known.recognise(query, {.most = 1, .scale = 14});
  EXPECT_TRUE(other.empty() || other[0].similarity < 0.7);
}

TEST(PackageRecognise, AKnownScaleHelpsInEveryUnit) {
  const std::vector<Outline> outlines = random_outlines(4);
  const double similarity = KnownOutlines(outlines).recognise(outlines[2], {.most = 1, .scale = 1}).at(0).similarity;
  for (const double known_unit : {1e-98, 1e-42, 1e-40, 1.0, 1e12}) {
    std::vector<Outline> known;
    for (const Outline& outline : outlines) known.push_back(test::mapped(outline, {known_unit, 0, 0, 0}));
    const KnownOutlines index(known);
    for (const double query_unit : {1e-98, 1e-40, 1.0, 1e12}) {
      const Outline query = test::mapped(outlines[2], {query_unit, 0, 0, 0});
      const double scale = query_unit / known_unit;
      const std::vector<Recognised> found = index.recognise(query, {.most = 1, .scale = scale});
      ASSERT_EQ(found.size(), 1u) << known_unit << " " << query_unit;
      EXPECT_EQ(found[0].known, 2u);
      EXPECT_NEAR(found[0].similarity, similarity, 0.01) << known_unit << " " << query_unit;
      EXPECT_NEAR(found[0].query_from_known.scale() / scale, 1, 0.02);
      for (const double wrong : {1e-30, 1e-5, 1e5, 1e30}) {
        if (scale * wrong > 1e119 || scale * wrong < 1e-119) continue;
        EXPECT_TRUE(index.recognise(query, {.most = 1, .scale = scale * wrong}).empty()) << scale << " " << wrong;
      }
    }
  }
}

TEST(PackageRecognise, AScaleNeedsKnownOutlinesOfSimilarSizes) {
  const Outline small = test::random_outline(1), large = test::mapped(test::random_outline(2), {1e8, 0, 0, 0});
  EXPECT_EQ(KnownOutlines({small, large}).recognise(large, {.most = 1, .scale = 1}).at(0).known, 1u);
  EXPECT_EQ(KnownOutlines({small, large}).recognise(small, {.most = 1, .scale = 1}).at(0).known, 0u);
  const KnownOutlines known({test::mapped(small, {1e-15, 0, 0, 0}), large});
  EXPECT_EQ(known.recognise(large, {.most = 1}).at(0).known, 1u);
  const std::string said = error_of([&] { known.recognise(large, {.most = 1, .scale = 1}); });
  EXPECT_NE(said.find("allowed with a scale: 1e20 times"), std::string::npos) << said;
}

TEST(PackageRecognise, OfSeveralCurvesTheLargestWithItsHolesIsKnown) {
  Outline ring = test::circle(100);
  Outline hole = test::mapped(test::random_outline(3), test::similarity(30, 0, 0, 0));
  Outline speck = test::mapped(test::circle(3), {1, 0, 300, 0});
  const Outline known = matching::make_outline({ring.curves[0].points, hole.curves[0].points, speck.curves[0].points});
  EXPECT_GT(KnownOutlines({known})
                .recognise(matching::make_outline({ring.curves[0].points, hole.curves[0].points}))
                .at(0)
                .similarity,
            0.9);
}

TEST(PackageRecognise, WhatCannotBeKnownIsNamed) {
  const Outline good = test::circle(1);
  const auto fault = [&](const Outline& outline) { return error_of([&] { KnownOutlines({good, outline}); }); };
  EXPECT_EQ(error_of([] { KnownOutlines(std::vector<Outline>{}); }), "no known outlines; allowed: 1 or more");
  EXPECT_EQ(fault({}), "outline 1: an outline without curves; allowed: 1 or more");
  EXPECT_EQ(fault(half(good)).substr(0, 32), "outline 1: found no closed curve");
  Outline inside_out = good;
  std::reverse(inside_out.curves[0].points.begin(), inside_out.curves[0].points.end());
  EXPECT_EQ(fault(inside_out).substr(0, 32), "outline 1: found no closed curve");
  EXPECT_EQ(fault(matching::make_outline({{{0, 0}, {1000, 0}, {1000, 1}, {0, 1}}})).substr(0, 19),
            "outline 1: too thin");
  EXPECT_EQ(fault(matching::make_outline({{{0, 0}, {1, 0}, {2, 1e-30}}})).substr(0, 19), "outline 1: too thin");
  Outline hollow = test::circle(1);
  for (const double radius : {0.9, 0.8}) {
    matching::Curve& hole = hollow.curves.emplace_back(test::circle(radius).curves[0]);
    std::reverse(hole.points.begin(), hole.points.end());
  }
  EXPECT_EQ(fault(hollow), "outline 1: found holes as large as the outer curve or larger, allowed: smaller ones");
  Outline comb;
  comb.curves.emplace_back();
  for (int i = 0; i < 2000; ++i) comb.curves[0].points.push_back({double(i), i % 2 ? 1000.0 : 0.0});
  comb.curves[0].points.push_back({2000, -2000});
  comb.curves[0].points.push_back({0, -2000});
  EXPECT_NE(fault(matching::make_outline({comb.curves[0].points})).find("its boundary is"), std::string::npos);
  const KnownOutlines known({good});
  EXPECT_EQ(error_of([&] { known.recognise(Outline{}); }), "an outline without curves; allowed: 1 or more");
  for (const double scale : {0.0, -1.0, std::nan(""), 1e300}) {
    EXPECT_EQ(error_of([&] { known.recognise(good, {.most = 1, .scale = scale}); }).substr(0, 6), "scale:");
  }
}

TEST(PackageRecognise, AMillionPoints) {
  const KnownOutlines known({test::random_outline(1, 1'000'000), test::random_outline(2)});
  EXPECT_EQ(known.recognise(test::random_outline(1)).at(0).known, 0u);
  EXPECT_EQ(known.recognise(test::random_outline(2, 1'000'000)).at(0).known, 1u);
}

TEST(PackageRecognise, AForkedProcessIsTold) {
  const KnownOutlines known({test::circle(1)});
  known.recognise(test::circle(1));
  const pid_t child = ::fork();
  if (child == 0) {
    const std::string said = error_of([&] { known.recognise(test::circle(1)); });
    ::_exit(said.find("was forked") == std::string::npos ? 1 : 0);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  EXPECT_EQ(status, 0);
}

/// Writes a library as `tessera library build` does.
void write_library(const std::string& path, int shapes) {
  LibraryWriter writer(path, {});
  for (int i = 0; i < shapes; ++i) {
    const Outline outline = i == 2 ? test::ring() : test::random_outline(std::uint32_t(i));
    TracedOutline traced;
    for (const matching::Curve& curve : outline.curves) {
      std::vector<Vec2> points;
      for (const matching::Point p : curve.points) points.push_back({float(100 * p.x), float(100 * p.y)});
      traced.curves.push_back(smoothing_spline(points, 1));
    }
    Shape shape = make_shape(traced, {});
    shape.name = "shape" + std::to_string(i);
    shape.artwork.width_px = shape.artwork.height_px = 600;
    writer.append(shape);
  }
  writer.finish();
}

TEST(PackageLibrary, NamesOutlinesPadsAndRecognition) {
  const test::ScratchFolder folder;
  write_library(folder.path("shapes.h5"), 6);
  const matching::Library library(folder.path("shapes.h5"));
  ASSERT_EQ(library.size(), 6u);
  EXPECT_EQ(library.names()[2], "shape2");
  EXPECT_EQ(library.pad_levels(), 5);
  EXPECT_NEAR(library.pad_delta_tau_rad(), 0.2, 1e-6);
  const Outline ring = library.outline(2);
  ASSERT_EQ(ring.curves.size(), 2u);
  EXPECT_NEAR(area_of(ring), 1, 1e-3);

  // The file's PADs are those that pads_of() computes with the level's smoothing.
  const std::vector<matching::Pad> pads = library.pads(4, 3);
  ASSERT_EQ(pads.size(), 128u);
  EXPECT_EQ(pads[0].left.size(), 5u);
  const std::vector<matching::Pad> computed =
      pads_of(library.outline(4), {.smoothing = matching::Library::smoothing(3), .samples = 128});
  ASSERT_EQ(computed.size(), 128u);
  EXPECT_NEAR(pads[64].along, computed[64].along, 0.02);
  EXPECT_LT(pad_distance(pads[64], computed[64]), 0.05);

  const KnownOutlines known(library);
  ASSERT_EQ(known.size(), 6u);
  for (std::size_t shape : {0u, 1u, 5u}) {
    const Outline query = test::mapped(library.outline(shape), test::similarity(300, 1, 20, 30));
    const std::vector<Recognised> found = known.recognise(query);
    ASSERT_GE(found.size(), 1u);
    EXPECT_EQ(found[0].known, shape);
    EXPECT_NEAR(found[0].query_from_known.scale(), 300, 3);
  }
}

TEST(PackageLibrary, WhatIsNoneIsNamed) {
  const test::ScratchFolder folder;
  const std::string text = folder.write("text.h5", "no library");
  EXPECT_EQ(error_of([&] { matching::Library{text}; }).substr(0, text.size()), text);
  EXPECT_NE(error_of([&] { matching::Library("none.h5"); }).find("none.h5"), std::string::npos);
  write_library(folder.path("one.h5"), 1);
  const matching::Library one(folder.path("one.h5"));
  EXPECT_EQ(error_of([&] { one.outline(1); }), folder.path("one.h5") + ": found the shape number 1, allowed: 0 to 0");
  EXPECT_EQ(error_of([&] { one.pads(0, 5); }), "level: found 5, allowed: 0 to 4");
  EXPECT_EQ(error_of([&] { matching::Library::smoothing(-1); }), "level: found -1, allowed: 0 to 4");
}

}  // namespace test_package_recognise
}  // namespace tessera
