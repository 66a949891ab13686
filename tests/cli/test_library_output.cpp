// The output of the library commands: the progress line and the final table.
#include <gtest/gtest.h>

#include "cli/library/build_summary.h"
#include "terminal/progress_bar.h"

namespace tessera::cli {
namespace test_library_output {

TEST(ProgressText, ForATerminalAndForALogFile) {
  EXPECT_EQ(progress_text("library", 50, 200, "31 shapes", 30, 0), "library: 25 %, 31 shapes, 0:30 left");
  EXPECT_EQ(progress_text("library", 100, 200, "31 shapes", 100, 200),
            "library  [###############...............]  50 %  31 shapes  1:40 left");
}

TEST(ProgressText, SaysNothingAboutTheTimeThatNobodyKnows) {
  EXPECT_EQ(progress_text("library", 0, 200, "", std::nullopt, 0), "library: 0 %");
  EXPECT_EQ(progress_text("library", 0, 0, "", std::nullopt, 0), "library: 100 %");
}

TEST(TimeLeft, FollowsFromThePace) {
  EXPECT_EQ(time_left_s(50, 200, 10), 30);
  EXPECT_EQ(time_left_s(0, 200, 10), std::nullopt);
  EXPECT_EQ(time_left_s(200, 200, 10), std::nullopt);
  EXPECT_EQ(time_left_s(0, 0, 10), std::nullopt);
}

/// The bar shrinks first, because users look for the time left.
TEST(ProgressText, FitsTheTerminal) {
  const std::string note = "231 pieces, 93.3 % covered, trial 50 of 150";
  EXPECT_EQ(progress_text("collage", 500, 1000, note, 100, 90),
            "collage  [#########........]  50 %  231 pieces, 93.3 % covered, trial 50 of 150  1:40 left");
  EXPECT_EQ(progress_text("collage", 500, 1000, note, 100, 79),
            "collage  50 %  231 pieces, 93.3 % covered, trial 50 of 150  1:40 left");
  EXPECT_EQ(progress_text("library", 1, 2, "a long note", 10, 20).size(), 20u);
}

TEST(BuildSummary, IsEmptyWhereAllIsUsed) {
  LibraryBuildReport report;
  report.files = report.shapes = 3;
  EXPECT_EQ(build_summary(report), "");
}

TEST(BuildSummary, CountsReasonsMostFrequentFirst) {
  LibraryBuildReport report;
  report.trimmed = {"/a/deer.svg"};
  report.faint = {"/a/fly.svg"};
  report.hollow = {"/a/bicycle.svg", "/a/chair.svg"};
  report.merged = {{"/a/red.svg", "blue"}};
  report.skipped = {{"/a/x.svg", "not a readable SVG file: line 3: no"},
                    {"/a/b\n.svg", "hairlines"},
                    {"/a/c.svg", "hairlines"},
                    {"/b/c.svg", "hairlines"},  // a copy
                    {"/a/d.svg", "hairlines"},
                    {"/a/e.svg", "hairlines"}};
  EXPECT_EQ(build_summary(report),
            "parts that do not touch the largest one are not in the silhouettes of 1: deer.svg\n"
            "  join the parts to include them; if a soft shadow joins them, --edge-opacity 0.05 includes them\n"
            "parts that are too faint (an opacity below 0.08) or too thin are not in the silhouettes of 1: fly.svg\n"
            "2 enclose twice what they cover or more, which leaves gaps; --fill-holes counts it as theirs: "
            "bicycle.svg, chair.svg\n"
            "merged 1 with the same silhouette and colour:\n"
            "  red.svg = blue\n"
            "skipped 6:\n"
            "      5  hairlines: b_.svg, c.svg, d.svg, ...\n"
            "      1  not a readable SVG file: x.svg\n");
}

TEST(BuildCounts, AddUpToTheFiles) {
  LibraryBuildReport report;
  report.files = report.shapes = 1;
  EXPECT_EQ(build_counts(report), "1 file: 1 shape");
  report.files = 9;
  report.shapes = 5;
  report.merged.resize(1);
  report.skipped.resize(3);
  EXPECT_EQ(build_counts(report), "9 files: 5 shapes, 1 merged with these, 3 skipped");
}

}  // namespace test_library_output
}  // namespace tessera::cli
