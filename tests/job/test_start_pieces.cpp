// The pieces of an earlier result: as the program wrote them, as people edit them, and invalid ones.
#include "job/pieces/start_pieces.h"

#include <gtest/gtest.h>

#include <array>

#include "result/geojson_output.h"
#include "support/input_error.h"
#include "support/sample_collage.h"
#include "support/scratch_folder.h"
#include "text/pose.h"

namespace tessera {
namespace test_start_pieces {

const std::vector<NamedShape> kShapes = {{"bear"}, {"disc"}, {"ring"}, {"bear", 0, true}};
const std::string kGood = R"({"shape":"disc","scale":40,"rotation_deg":90,"x_px":50.5,"y_px":-20})";

std::string collection(const std::string& features) {
  return R"({"type":"FeatureCollection","features":[)" + features + "]}";
}

std::string feature(const std::string& properties) {
  return R"({"type":"Feature","properties":)" + properties + R"(,"geometry":{"type":"Polygon","coordinates":[]}})";
}

std::string repeated(const std::string& text, std::size_t times) {
  std::string all;
  for (std::size_t i = 0; i < times; ++i) all += text;
  return all;
}

class StartPieces : public testing::Test {
 protected:
  std::vector<GivenPiece> pieces_in(const std::string& bytes) {
    Job job;
    job.start.pieces = folder_.write("pieces.geojson", bytes);
    return added(job);
  }

  static std::vector<GivenPiece> added(Job& job) {
    job.path = "job.toml";
    add_start_pieces(kShapes, job);
    return job.settings.wishes.given;
  }

  std::string mistake(const std::string& bytes) {
    return test::message_of([&] { pieces_in(bytes); });
  }

  void expect_mistake(const std::string& properties, const std::string& said) {
    const std::string where = "job.toml: start.pieces: " + folder_.path("pieces.geojson") + ": feature 1: ";
    EXPECT_EQ(mistake(collection(feature(kGood) + "," + feature(properties))).substr(0, (where + said).size()),
              where + said);
  }

  test::ScratchFolder folder_;
};

/// The poses are equal to the last bit, so that unmoved pieces keep their polygons.
TEST_F(StartPieces, AreThoseThatAResultHas) {
  test::SampleCollage collage;
  collage.report.placements[0].canvas_from_shape = {12.345678f, -34.56789f, 50.0001f, 0.1f};
  const std::vector<GivenPiece> pieces = pieces_in(geojson_text(collage.report));
  ASSERT_EQ(pieces.size(), 2u);
  EXPECT_EQ(pieces[0].shape, ShapeId{1});
  EXPECT_EQ(pieces[1].shape, ShapeId{2});
  for (std::size_t i = 0; i < 2; ++i) {
    const Placement& then = collage.report.placements[i];
    EXPECT_EQ(pieces[i].canvas_from_shape, then.canvas_from_shape);
    EXPECT_EQ(pieces[i].score, then.score);
    EXPECT_EQ(pieces[i].matched_px, then.matched_px);
  }
}

/// People read and change the rounded numbers. If an exact pose differs from them, it is out of date.
TEST_F(StartPieces, WhatPeopleChangeCounts) {
  const std::string before = R"(,"canvas_from_shape":[0.0,40.0,50.5,-20.00049],"score":0.5,"matched_px":3})";
  const auto piece = [&](const std::string& numbers) {
    return pieces_in(collection(feature(R"({"shape":"disc",)" + numbers + before))).at(0);
  };
  const GivenPiece same = piece(R"("scale":40,"rotation_deg":90,"x_px":50.5,"y_px":-20)");
  EXPECT_EQ(same.canvas_from_shape, (Similarity{0, 40, 50.5f, -20.00049f}));
  EXPECT_EQ(same.score, 0.5f);
  EXPECT_EQ(same.matched_px, 3);
  const std::array changed = {R"("scale":40.001,"rotation_deg":90,"x_px":50.5,"y_px":-20)",
                              R"("scale":40,"rotation_deg":90.001,"x_px":50.5,"y_px":-20)",
                              R"("scale":40,"rotation_deg":90,"x_px":50.501,"y_px":-20)",
                              R"("scale":40,"rotation_deg":90,"x_px":50.5,"y_px":-20.001)"};
  for (const char* numbers : changed) {
    const GivenPiece other = piece(numbers);
    EXPECT_NE(other.canvas_from_shape, same.canvas_from_shape);
    EXPECT_EQ(other.score, 0) << "of a piece that stood elsewhere";
    EXPECT_EQ(other.matched_px, 0);
  }
  expect_mistake(R"({"shape":"disc","scale":40,"rotation_deg":0,"x_px":0,"y_px":0,"canvas_from_shape":[1,2,3]})",
                 "canvas_from_shape: found [1,2,3], allowed: four numbers from -40000 to 40000");
  expect_mistake(R"({"shape":"disc","scale":40,"rotation_deg":0,"x_px":0,"y_px":0,"canvas_from_shape":[1,2,3,1e9]})",
                 "canvas_from_shape: found [1,2,3,1000000000.0], allowed: four numbers");
  expect_mistake(R"({"shape":"disc","scale":40,"rotation_deg":0,"x_px":0,"y_px":0,"canvas_from_shape":"a"})",
                 "canvas_from_shape: found \"a\", allowed: four numbers");
}

std::string any_piece(int x_px, bool locked = false) {
  return feature(R"({"shape":"disc","scale":9,"rotation_deg":0,"x_px":)" + std::to_string(x_px) + R"(,"y_px":2)" +
                 (locked ? R"(,"locked":true})" : "}"));
}

TEST_F(StartPieces, StandingOnesStayAndAreNoMoreLockedThanBefore) {
  Job job;
  job.start.keep = StartKeep::standing;
  job.start.pieces = folder_.write("pieces.geojson", collection(any_piece(0) + "," + any_piece(1, true)));
  const std::vector<GivenPiece> pieces = added(job);
  ASSERT_EQ(pieces.size(), 2u);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_TRUE(pieces[i].locked);
    EXPECT_EQ(pieces[i].canvas_from_shape.tx, float(i)) << "in their order";
    EXPECT_EQ(pieces[i].for_good, i == 1);
  }
}

TEST_F(StartPieces, SomeAreRemovedAndSomeLocked) {
  Job job;
  job.start.keep = StartKeep::standing;
  job.start.remove = {2, 0};
  job.start.lock = {3};
  job.start.pieces = folder_.write(
      "pieces.geojson", collection(any_piece(0) + "," + any_piece(1) + "," + any_piece(2) + "," + any_piece(3)));
  const std::vector<GivenPiece> pieces = added(job);
  ASSERT_EQ(pieces.size(), 2u);
  EXPECT_EQ(pieces[0].canvas_from_shape.tx, 1);
  EXPECT_FALSE(pieces[0].for_good);
  EXPECT_EQ(pieces[1].canvas_from_shape.tx, 3);
  EXPECT_TRUE(pieces[1].locked && pieces[1].for_good);
  ASSERT_EQ(job.start.removed.size(), 2u);
  EXPECT_EQ(job.start.removed[0].canvas_from_shape.tx, 0);
  EXPECT_EQ(job.start.removed[1].canvas_from_shape.tx, 2);
  job.start.keep = StartKeep::free;
  job.start.remove = {};
  job.settings.wishes.given = {};
  EXPECT_EQ(added(job)[0].canvas_from_shape.tx, 3) << "the locked one first";
  EXPECT_EQ(job.settings.wishes.locked(), 1u);
}

TEST_F(StartPieces, TheBytesThatTheyAreOfAreTold) {
  Job one, same, other;
  one.start.pieces = folder_.write("one.geojson", collection(any_piece(0)));
  same.start.pieces = folder_.write("same.geojson", collection(any_piece(0)));
  other.start.pieces = folder_.write("other.geojson", collection(any_piece(1)));
  for (Job* job : {&one, &same, &other}) added(*job);
  EXPECT_EQ(one.start.digest, same.start.digest);
  EXPECT_NE(one.start.digest, other.start.digest);
}

TEST_F(StartPieces, NobodyRemovesWhatIsNotThereOrLocked) {
  const std::string file = folder_.write("pieces.geojson", collection(any_piece(0) + "," + any_piece(1, true)));
  const auto mistake_of = [&](const std::vector<int>& remove, const std::vector<int>& lock) {
    Job job;
    job.start.pieces = file;
    job.start.remove = remove;
    job.start.lock = lock;
    return test::message_of([&] { added(job); });
  };
  const std::string where = "job.toml: start.pieces: " + file + ": ";
  EXPECT_EQ(mistake_of({2}, {}), where + "start.remove: found 2, allowed: 0 to 1, the pieces of the file");
  EXPECT_EQ(mistake_of({}, {9}), where + "start.lock: found 9, allowed: 0 to 1, the pieces of the file");
  EXPECT_EQ(mistake_of({1}, {}), where + "start.remove: found 1, which is locked");
  EXPECT_EQ(mistake_of({0}, {1}), "");
}

TEST_F(StartPieces, ComeAfterThoseThatAreGiven) {
  Job job;
  job.start.pieces = folder_.write("pieces.geojson", collection(feature(kGood)));
  job.settings.wishes.given = {{ShapeId{0}, {}}};
  ASSERT_EQ(added(job).size(), 2u);
  EXPECT_EQ(job.settings.wishes.given[0].shape, ShapeId{0});
  EXPECT_TRUE(job.settings.wishes.given[1].locked);
  job.settings.wishes.given.resize(1);
  job.start.keep = StartKeep::free;
  EXPECT_FALSE(added(job)[1].locked);
  EXPECT_TRUE(job.settings.wishes.given[0].locked);
}

TEST_F(StartPieces, ThoseThatTheFileLocksStandThoughOthersAreFree) {
  const std::string locked = R"({"shape":"ring","scale":9,"rotation_deg":0,"x_px":1,"y_px":2,"locked":true})";
  const std::string loose = R"({"shape":"bear","scale":9,"rotation_deg":0,"x_px":1,"y_px":2,"locked":false})";
  Job job;
  job.start.keep = StartKeep::free;
  job.start.pieces =
      folder_.write("pieces.geojson", collection(feature(kGood) + "," + feature(locked) + "," + feature(loose)));
  const std::vector<GivenPiece> pieces = added(job);
  ASSERT_EQ(pieces.size(), 3u);
  EXPECT_EQ(pieces[0].shape, ShapeId{2}) << "the locked one first";
  EXPECT_EQ(job.settings.wishes.locked(), 1u);
  EXPECT_EQ(pieces[1].shape, ShapeId{1});
  expect_mistake(R"({"shape":"disc","scale":40,"rotation_deg":0,"x_px":0,"y_px":0,"locked":1})",
                 "locked: found 1, allowed: true or false");
}

/// A result holds the given pieces among its pieces.
TEST_F(StartPieces, ThoseOfGivenDoNotStandTwice) {
  Job job;
  job.canvas.seamless = Seamless::x;
  job.canvas.width_px = 300;
  job.settings.wishes.given = {{ShapeId{1}, pose_of(40.0004, 449.9996, 350.4997, -20)}};
  job.start.pieces = folder_.write("pieces.geojson", collection(feature(kGood) + "," + feature(kGood)));
  const GivenPiece given = job.settings.wishes.given[0];
  const std::vector<GivenPiece> pieces = added(job);
  ASSERT_EQ(pieces.size(), 2u) << "each stands for one";
  EXPECT_EQ(pieces[0], given) << "as the job gives it";
  job.settings.wishes.given = {{ShapeId{1}, pose_of(40, 90, 50.6, -20)}, {ShapeId{0}, pose_of(40, 90, 50.5, -20)}};
  EXPECT_EQ(added(job).size(), 4u) << "beside it, and another one";
}

TEST_F(StartPieces, TheFolderOfAResultIsAsGoodAsItsFile) {
  folder_.write("pieces.geojson", collection(feature(kGood)));
  Job job;
  job.start.pieces = folder_.path("");
  EXPECT_EQ(added(job).size(), 1u);
  EXPECT_EQ(start_file(job), folder_.path("") + "pieces.geojson");
  EXPECT_EQ(start_file(Job()), "");
}

TEST_F(StartPieces, AFileWithoutPiecesHasNone) { EXPECT_TRUE(pieces_in(collection("")).empty()); }

TEST_F(StartPieces, WhatElseAFileHoldsDoesNotMatter) {
  const std::string more = R"({"shape":"disc","scale":4e1,"rotation_deg":-360,"x_px":1,"y_px":2,"mirrored":false,)"
                           R"("name":{"a":[1,2]},"fill":"red"})";
  EXPECT_EQ(pieces_in(collection(feature(more))).size(), 1u);
}

TEST_F(StartPieces, MistakesNameTheFeatureTheKeyAndWhatIsAllowed) {
  expect_mistake(
      R"({"shape":"disk","scale":40,"rotation_deg":0,"x_px":0,"y_px":0})",
      "shape: found \"disk\", allowed: the name of a shape of the library (tessera library info FILE --names "
      "lists them); did you mean \"disc\"?");
  expect_mistake(R"({"scale":40,"rotation_deg":0,"x_px":0,"y_px":0})", "shape: found nothing, allowed: the name");
  expect_mistake(R"({"shape":7,"scale":40,"rotation_deg":0,"x_px":0,"y_px":0})", "shape: found 7, allowed: the name");
  expect_mistake(R"({"shape":"disc","scale":"big","rotation_deg":0,"x_px":0,"y_px":0})",
                 "scale: found \"big\", allowed: a number from 0.01 to 20000");
  expect_mistake(R"({"shape":"disc","scale":0,"rotation_deg":0,"x_px":0,"y_px":0})",
                 "scale: found 0, allowed: a number from 0.01 to 20000");
  expect_mistake(R"({"shape":"disc","scale":[40],"rotation_deg":0,"x_px":0,"y_px":0})", "scale: found ");
  expect_mistake(R"({"shape":"disc","scale":40,"rotation_deg":361,"x_px":0,"y_px":0})",
                 "rotation_deg: found 361, allowed: a number from -360 to 360");
  expect_mistake(R"({"shape":"disc","scale":40,"rotation_deg":0,"x_px":40001,"y_px":0})",
                 "x_px: found 40001, allowed: a number from -20000 to 40000");
  expect_mistake(R"({"shape":"disc","scale":40,"rotation_deg":0,"x_px":0})",
                 "y_px: found nothing, allowed: a number from -20000 to 40000");
  expect_mistake(R"({"shape":"disc","scale":40,"rotation_deg":0,"x_px":0,"y_px":0,"mirrored":true})",
                 "mirrored: found true, allowed: false, as pieces.mirrored says of this shape");
  expect_mistake(R"({"shape":"disc","scale":40,"rotation_deg":0,"x_px":0,"y_px":0,"mirrored":1})",
                 "mirrored: found 1, allowed: true or false");
  expect_mistake("7", "shape: found nothing");
}

/// Other programs add members beside the features and the poses. The reader skips them, however long they are.
TEST_F(StartPieces, OtherMembersOfGeoJsonArePassedOver) {
  const std::string many = "[" + repeated("7,", 100) + "{\"shape\":[" + repeated("7,", 100) + "7]}]";
  const std::string with_notes =
      std::string(R"({"type":"Feature","bbox":)") + many + R"(,"geometry":{"type":"Point","bbox":)" + many +
      R"(,"shape":)" + many + R"(},"properties":{"tags":)" + many + R"(,"a":{"shape":)" + many +
      R"(},"shape":"disc","scale":9,"rotation_deg":0,"x_px":4,"y_px":2},"notes":)" + many + "}";
  for (const std::string& head :
       {std::string(R"("bbox":[0,0,9,9],)"), "\"notes\":" + many + ",",
        std::string(R"("crs":{"type":"name","properties":{"name":"x"},"features":[7,{}]},)")}) {
    const std::string file =
        "{" + head + R"("features":[)" + with_notes + "]," + head + R"("type":"FeatureCollection"})";
    const std::vector<GivenPiece> pieces = pieces_in(file);
    ASSERT_EQ(pieces.size(), 1u) << head;
    EXPECT_EQ(pieces[0].canvas_from_shape.tx, 4) << head;
  }
}

TEST_F(StartPieces, WhatIsNoResultIsAMistake) {
  EXPECT_NE(mistake("").find("no JSON"), std::string::npos);
  EXPECT_NE(mistake("{\"features\":[").find("no JSON"), std::string::npos);
  EXPECT_NE(mistake("\xff\xfe{}").find("no JSON"), std::string::npos);
  EXPECT_NE(mistake("7").find("features: found nothing, allowed: a list of features"), std::string::npos);
  EXPECT_NE(mistake("{}").find("features: found nothing"), std::string::npos);
  EXPECT_NE(mistake("{\"features\":{}}").find("features: found {}, allowed"), std::string::npos);
  EXPECT_NE(mistake(collection("7")).find("feature 0: properties: found nothing"), std::string::npos);
  EXPECT_NE(mistake(collection(feature(R"({"shape":"disc","scale":1e999,"rotation_deg":0,"x_px":0,"y_px":0})")))
                .find("no JSON"),
            std::string::npos);
}

TEST_F(StartPieces, FilesThatWouldEatTheMachineAreRefused) {
  EXPECT_NE(mistake(repeated("[", 100000)).find("more than 32 levels deep"), std::string::npos);
  EXPECT_NE(mistake(repeated("{\"a\":", 100000)).find("more than 32 levels deep"), std::string::npos);
  EXPECT_NE(mistake(collection(repeated(feature(kGood) + ",", 100'000) + "{}")).find("more than 100000 features"),
            std::string::npos);
  EXPECT_NE(mistake(collection(feature(R"({"shape":"disc","canvas_from_shape":[)" + repeated("1,", 100) + "1]}")))
                .find("feature 0: properties: found more than 16 values in lists, allowed: 16 or fewer"),
            std::string::npos);
}

TEST_F(StartPieces, ThereMustBeAFile) {
  Job job;
  job.start.pieces = folder_.path("none.geojson");
  const std::string allowed = "; allowed: the folder of a result, or its pieces.geojson";
  EXPECT_EQ(test::message_of([&] { added(job); }),
            "job.toml: start.pieces: " + folder_.path("none.geojson") + ": no such file or folder" + allowed);
  job.start.pieces = folder_.path("");
  EXPECT_EQ(test::message_of([&] { added(job); }),
            "job.toml: start.pieces: " + folder_.path("") + ": found a folder without pieces.geojson" + allowed);
  job.start.pieces = "/dev/null";
  EXPECT_NE(test::message_of([&] { added(job); }).find("/dev/null: not a readable file: found a device"),
            std::string::npos);
}

TEST_F(StartPieces, TheRunMayNotReplaceThem) {
  Job job;
  job.path = "job.toml";
  job.start.pieces = folder_.write("pieces.geojson", collection(""));
  EXPECT_NE(test::message_of([&] { check_start_is_elsewhere(job, folder_.path("")); }).find("give another --out"),
            std::string::npos);
  EXPECT_EQ(test::message_of([&] { check_start_is_elsewhere(job, testing::TempDir()); }), "");
  EXPECT_EQ(test::message_of([&] { check_start_is_elsewhere(Job(), folder_.path("")); }), "");
}

}  // namespace test_start_pieces
}  // namespace tessera
