// All that a run leaves behind.
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>

#include "core/base/error.h"
#include "sample_collage.h"
#include "scratch_folder.h"

namespace tessera::io {
namespace {

namespace fs = std::filesystem;

std::set<std::string> names_in(const std::string& dir) {
  std::set<std::string> names;
  for (const auto& entry : fs::directory_iterator(dir)) names.insert(entry.path().filename());
  return names;
}

std::string content_of(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

TEST(CollageFiles, WritesThemAllAndNothingElse) {
  const test::ScratchFolder folder;
  const test::SampleCollage sample;
  const std::string dir = folder.path("out");
  prepare_output_directory(dir);
  EXPECT_TRUE(names_in(dir).empty());
  for (const bool quick : {false, true}) {
    const std::string card = write_collage(dir, sample.report, quick);
    EXPECT_EQ(names_in(dir), (std::set<std::string>{"pieces.geojson", "card.json", "card.txt", "job.toml", "collage.svg",
                                                    "collage.png"}));
    EXPECT_EQ(content_of(dir + "/card.txt"), card);
    // Disc of 40 px squared and ring of 60 px squared on 200 x 100 px.
    EXPECT_NE(card.find("26.0"), std::string::npos) << card;
  }
}

TEST(CollageFiles, TheSameReportGivesTheSameBytes) {
  const test::ScratchFolder folder;
  const test::SampleCollage sample;
  for (const char* dir : {"a", "b"}) {
    prepare_output_directory(folder.path(dir));
    write_collage(folder.path(dir), sample.report, false);
  }
  for (const std::string& name : names_in(folder.path("a"))) {
    EXPECT_EQ(content_of(folder.path("a/" + name)), content_of(folder.path("b/" + name))) << name;
  }
}

TEST(CollageFiles, PreparesFoldersInFolders) {
  const test::ScratchFolder folder;
  prepare_output_directory(folder.path("a/b/c"));
  EXPECT_TRUE(fs::is_directory(folder.path("a/b/c")));
  prepare_output_directory(folder.path("a/b/c"));
}

TEST(CollageFiles, AFileInTheWayIsAnError) {
  const test::ScratchFolder folder;
  const std::string file = folder.write("file", "x");
  EXPECT_THROW(prepare_output_directory(file), EnvironmentError);
  EXPECT_THROW(prepare_output_directory(file + "/below"), EnvironmentError);
}

TEST(CollageFiles, AFolderThatCannotBeWrittenIsAnErrorBeforeTheWork) {
  if (geteuid() == 0) GTEST_SKIP() << "root may write anywhere";
  const test::ScratchFolder folder;
  const std::string dir = folder.path("locked");
  fs::create_directory(dir);
  fs::permissions(dir, fs::perms::owner_read | fs::perms::owner_exec);
  EXPECT_THROW(prepare_output_directory(dir), EnvironmentError);
  fs::permissions(dir, fs::perms::owner_all);
}

TEST(CollageFiles, AShapeThatIsMissingFromTheReportIsABug) {
  const test::SampleCollage sample;
  EXPECT_EQ(sample.report.shape(3).name, "ring");
  EXPECT_THROW(sample.report.shape(4), std::out_of_range);
}

}  // namespace
}  // namespace tessera::io
