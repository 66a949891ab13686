// All files that a run leaves behind.
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>

#include "core/base/error.h"
#include "render/card_drawing.h"
#include "result/folder/result_manifest.h"
#include "result/placed_pieces.h"
#include "support/input_error.h"
#include "support/sample_collage.h"
#include "support/scratch_folder.h"

namespace tessera {
namespace test_collage_files {

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
  for (const bool finished : {false, true}) {
    const std::string card = publish_result(dir, sample.report, sample.source(), finished);
    EXPECT_EQ(names_in(dir),
              (std::set<std::string>{"pieces.geojson", "card.json", "card.txt", "job.toml", "manifest.json"}));
    EXPECT_EQ(read_manifest(dir).finished, finished);
    EXPECT_EQ(content_of(dir + "/card.txt"), card);
    // A disc of 40 px squared and a ring of 60 px squared on 200 x 100 px.
    EXPECT_NE(card.find("26.0"), std::string::npos) << card;
  }
}

TEST(CollageFiles, TheSameReportGivesTheSameBytes) {
  const test::ScratchFolder folder;
  const test::SampleCollage sample;
  for (const char* dir : {"a", "b"}) {
    prepare_output_directory(folder.path(dir));
    publish_result(folder.path(dir), sample.report, sample.source(), true);
  }
  for (const std::string& name : names_in(folder.path("a"))) {
    EXPECT_EQ(content_of(folder.path("a/" + name)), content_of(folder.path("b/" + name))) << name;
  }
}

TEST(CollageFiles, ThePicturesOfTheRunBeforeDoNotStandBesideNewPieces) {
  const test::ScratchFolder folder;
  const test::SampleCollage sample;
  for (const char* name : {"collage.png", "collage.svg", "collage.pdf", "collage.tiff", "collage.png.tmp"})
    folder.write(name, "old");
  publish_result(folder.path(""), sample.report, sample.source(), true);
  EXPECT_EQ(names_in(folder.path("")),
            (std::set<std::string>{"pieces.geojson", "card.json", "card.txt", "job.toml", "manifest.json"}));
}

TEST(CollageFiles, WhereAFileCannotBeWrittenThereIsNoResult) {
  const test::ScratchFolder folder;
  const test::SampleCollage sample;
  publish_result(folder.path(""), sample.report, sample.source(), true);
  fs::create_directories(folder.path("card.txt.tmp/in_the_way"));  // this file is the last one before the manifest
  EXPECT_THROW(publish_result(folder.path(""), sample.report, sample.source(), true), EnvironmentError);
  EXPECT_THROW(read_manifest(folder.path("")), InputError);
}

/// The launcher may kill the program while it measures.
TEST(CollageFiles, AnUnfinishedResultIsOneBeforeItsCards) {
  const test::ScratchFolder folder;
  const test::SampleCollage sample;
  publish_result(folder.path(""), sample.report, sample.source(), false);
  fs::create_directories(folder.path("card.json.tmp/in_the_way"));
  EXPECT_THROW(publish_result(folder.path(""), sample.report, sample.source(), false), EnvironmentError);
  EXPECT_FALSE(read_manifest(folder.path("")).finished);
  EXPECT_FALSE(fs::exists(folder.path("card.json"))) << "that of the result before";
  EXPECT_FALSE(fs::exists(folder.path("card.txt")));
}

TEST(CollageFiles, AManifestBelongsToItsFiles) {
  const test::ScratchFolder folder;
  const test::SampleCollage sample;
  for (const char* name : {"pieces.geojson", "job.toml"}) {
    publish_result(folder.path(""), sample.report, sample.source(), true);
    const ResultManifest manifest = read_manifest(folder.path(""));
    EXPECT_EQ(manifest.shapes, (std::vector{ShapeId{7}, ShapeId{3}}));
    write_manifest(folder.path(""), manifest);
    EXPECT_EQ(read_manifest(folder.path("")), manifest);
    folder.write(name, content_of(folder.path(name)) + " ");
    EXPECT_NE(test::message_of([&] { read_manifest(folder.path("")); }).find(name), std::string::npos);
  }
  folder.write("manifest.json", R"({"format": 1, "state": "finished"})");
  EXPECT_NE(test::message_of([&] { read_manifest(folder.path("")); }).find("manifest.json: not a manifest"),
            std::string::npos);
}

TEST(CollageFiles, PiecesAreReadBackAsTheyWereWritten) {
  const test::ScratchFolder folder;
  const test::SampleCollage sample;
  publish_result(folder.path(""), sample.report, sample.source(), true);
  const std::vector<PlacedPiece> pieces = read_placed_pieces(folder.path(""));
  ASSERT_EQ(pieces.size(), sample.report.placements.size());
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const Similarity& placed = sample.report.placements[i].canvas_from_shape;
    EXPECT_NEAR(pieces[i].canvas_from_shape.a, placed.a, 0.002);
    EXPECT_NEAR(pieces[i].canvas_from_shape.b, placed.b, 0.002);
    EXPECT_EQ(pieces[i].canvas_from_shape.translation(), placed.translation());
    EXPECT_EQ(pieces[i].shape,
              sample.report.shapes.names()[sample.report.shapes.slot_of(sample.report.placements[i].shape)]);
  }
}

TEST(CollageFiles, TheCardsTellOfTheLatestDrawing) {
  const test::ScratchFolder folder;
  const test::SampleCollage sample;
  const std::string card = publish_result(folder.path(""), sample.report, sample.source(), true);
  DrawingNotes notes;
  notes.pieces = 2;
  notes.seconds = 12.34;
  notes.notes = {{"disc", DrawnFrom::thumbnail, "original missing", 1}};
  for (int i = 0; i < 2; ++i) add_drawing_to_cards(folder.path(""), notes);
  EXPECT_EQ(content_of(folder.path("card.txt")),
            card + "Drawing\n  drawing time            12.3 s\n  drawn from thumbnail    1 piece: original missing\n");
  EXPECT_NE(content_of(folder.path("card.json")).find("original missing"), std::string::npos);
  EXPECT_NE(content_of(folder.path("card.json")).find("\"seconds\": 12.34"), std::string::npos);
  read_manifest(folder.path(""));
  add_drawing_to_cards(folder.path(""), {.pieces = 2});
  EXPECT_EQ(content_of(folder.path("card.txt")), card + "Drawing\n  drawing time            0.0 s\n");
}

TEST(CollageFiles, ADrawingIsNotLostWithACard) {
  const test::ScratchFolder folder;
  const test::SampleCollage sample;
  publish_result(folder.path(""), sample.report, sample.source(), true);
  std::filesystem::remove(folder.path("card.json"));
  DrawingNotes notes{.pieces = 2, .notes = {{"disc", DrawnFrom::thumbnail, "original missing", 1}}};
  notes.cards = add_drawing_to_cards(folder.path(""), notes);
  ASSERT_EQ(notes.cards.size(), 1u);
  EXPECT_NE(drawing_warning(notes).find("the card does not tell of this drawing: " + folder.path("card.json") +
                                        ": not found"),
            std::string::npos);
  EXPECT_NE(content_of(folder.path("card.txt")).find("original missing"), std::string::npos);
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
  EXPECT_THROW(prepare_output_directory(file), InputError);
  EXPECT_THROW(prepare_output_directory(file + "/below"), InputError);
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
  EXPECT_EQ(sample.report.shape(ShapeId{3}).name, "ring");
  EXPECT_THROW(sample.report.shape(ShapeId{4}), std::out_of_range);
}

}  // namespace test_collage_files
}  // namespace tessera
