// Drawings that the public library reads, and a missing drawer.
#include <gtest/gtest.h>

#include <cstdlib>

#include "sample_outlines.h"
#include "support/scratch_folder.h"

namespace tessera {
namespace test_package_drawing {

using test::error_of;

std::string duck(const std::string& number) { return TESSERA_SOURCE_DIR "/docs/matching/duck" + number + ".svg"; }

TEST(PackageDrawing, TheSeriesOfTheGuide) {
  const matching::Outline a = matching::read_drawing(duck(""));
  EXPECT_GT(a.smoothing, 0);
  EXPECT_GT(area_of(a), 0);
  EXPECT_NEAR(match(a, matching::read_drawing(duck("-4"))).at(0).score, 0.656, 0.01);  // docs/matching.md
}

TEST(PackageDrawing, Strokes) {
  const test::ScratchFolder folder;
  const std::string svg = folder.write("line.svg",
                                       "<svg xmlns='http://www.w3.org/2000/svg' width='300' height='300'>"
                                       "<path fill='none' stroke='black' stroke-width='5' d='M20 20H220'/></svg>");
  const matching::Outline lines = matching::read_drawing(svg, matching::Trace::centre_lines);
  ASSERT_EQ(lines.curves.size(), 1u);
  EXPECT_FALSE(lines.curves[0].closed);
  EXPECT_NEAR(length_of(lines), 200, 8);
}

TEST(PackageDrawing, WhatIsOfNoUseIsNamed) {
  const test::ScratchFolder folder;
  const std::string empty = folder.write("empty.svg", "");
  EXPECT_EQ(error_of([&] { matching::read_drawing(empty); }).substr(0, empty.size() + 1), empty + ":");
  EXPECT_NE(error_of([] { matching::read_drawing("none.svg"); }).find("none.svg"), std::string::npos);
}

TEST(PackageDrawing, AMissingDrawerIsNamed) {
  const std::string place = std::getenv("TESSERA_DRAWER");
  ::unsetenv("TESSERA_DRAWER");
  const std::string said = error_of([] { matching::read_drawing(duck("")); });
  ::setenv("TESSERA_DRAWER", place.c_str(), 1);
  EXPECT_NE(said.find("tessera-drawer, which reads drawings, is missing: looked for "), std::string::npos) << said;
  EXPECT_NE(said.find("/libexec/tessera/tessera-drawer; TESSERA_DRAWER=FILE names another place"), std::string::npos)
      << said;
}

}  // namespace test_package_drawing
}  // namespace tessera
