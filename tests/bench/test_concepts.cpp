#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <string>

#include "bench/benchmarks.h"
#include "bench/concepts/figures.h"
#include "bench/concepts/pad_drawing.h"
#include "bench/formula_library.h"
#include "core/base/error.h"
#include "files/regular_file.h"
#include "support/scratch_folder.h"

namespace tessera::bench::concepts {
namespace {

constexpr std::size_t kMostBytes = 16u << 20;

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
  return found;
}

std::string dots_of(const std::string& colour) { return "fill=\"" + colour + "\"/>"; }

const std::string& library_path() {
  static const test::FormulaLibrary library(60);
  return library.path();
}

TEST(Concepts, EachFigureIsDrawn) {
  const test::ScratchFolder folder;
  draw_concepts({.library = library_path(), .folder = folder.path("figures")});
  for (const char* name : {"shapes", "target", "pairs", "dockings", "choice", "merge", "improving", "ranks"}) {
    const std::vector<std::uint8_t> bytes =
        read_regular_file(folder.path(std::string("figures/") + name + ".svg"), kMostBytes);
    const std::string svg(bytes.begin(), bytes.end());
    EXPECT_NE(svg.find("<svg "), std::string::npos) << name;
    EXPECT_GT(count(svg, "<path "), 3u) << name;
  }
}

TEST(Concepts, AShapeThatIsNotThereIsRefused) {
  const test::ScratchFolder folder;
  EXPECT_THROW(draw_concepts({.library = library_path(), .folder = folder.path("figures"), .shape = "dolphin"}),
               InputError);
}

TEST(Concepts, TheTreeHasEachRankOnce) {
  const LibraryFile library(library_path());
  CollageStage stage(library, "all", {44, 120});
  stage.place(2);
  const std::string svg = ranks_figure(stage);
  EXPECT_EQ(count(svg, "<circle "), 21u);
  EXPECT_EQ(stage.collage().placements().size(), 3u) << "the round that was weighed placed a piece";
}

TEST(Concepts, AMergeCutsOldSamplesAndPastesNewOnes) {
  const LibraryFile library(library_path());
  CollageStage stage(library, "all", {44, 120});
  stage.place(3);
  const std::string svg = merge_figure(stage);
  EXPECT_GT(count(svg, dots_of(kOrange)), 0u);
  EXPECT_GT(count(svg, dots_of(kGreen)), 0u);
}

TEST(Concepts, BarsOfAConcavePointHangDown) {
  Pad pad;
  pad.element.fill(0.5f);
  pad.convexity = 1;
  const Box box{{0, 0}, {80, 100}};
  FigureSheet convex(80, 100);
  draw_pad_bars(convex, box, pad, 5);
  EXPECT_NE(convex.finish().find(",50.0 "), std::string::npos);
  pad.convexity = -1;
  pad.element.fill(0.25f);
  FigureSheet concave(80, 100);
  draw_pad_bars(concave, box, pad, 5);
  EXPECT_NE(concave.finish().find(",25.0"), std::string::npos);
}

TEST(Concepts, TheLeastElementIsOneOfThoseInUse) {
  Pad pad;
  pad.element.fill(0);
  for (int i = 0; i < 4; ++i) pad.element[std::size_t(i)] = 0.5f;
  EXPECT_EQ(least_element(pad, 3), 0.5f);
  EXPECT_EQ(least_element(pad, 4), 0);
}

}  // namespace
}  // namespace tessera::bench::concepts
