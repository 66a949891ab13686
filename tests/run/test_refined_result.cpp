// The job that tessera refine makes from a result's job, and its folder.
#include "run/refined_result.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "support/input_error.h"

namespace tessera::cli {
namespace test_refined_result {

RefinedResult result_of(const StopSettings& stop, std::size_t pieces, std::size_t regions = 0) {
  RefinedResult result;
  result.folder = "out/a b";
  result.whole.job.settings.stop = stop;
  result.whole.job.tables["regions"].resize(regions);
  result.whole.manifest.shapes.resize(pieces);
  return result;
}

std::string key(const std::vector<std::string>& keys, const std::string& name) {
  for (const std::string& text : keys)
    if (text.starts_with(name + "=")) return text.substr(name.size() + 1);
  return "missing";
}

TEST(RefinedResult, LimitsThatMayHaveEndedItEndNoRelaxingAndLeaveItsNumberOfPieces) {
  const auto most_pieces = [](const StopSettings& stop) {
    const std::vector<std::string> keys = relaxing_keys(result_of(stop, 120), 0);
    EXPECT_EQ(key(keys, "stop.coverage"), "1");
    EXPECT_EQ(key(keys, "stop.seconds"), "0");
    return key(keys, "stop.pieces");
  };
  EXPECT_EQ(most_pieces({}), "0");
  EXPECT_EQ(most_pieces({.pieces = 200}), "200");
  EXPECT_EQ(most_pieces({.pieces = 100}), "120") << "so many were given";
  EXPECT_EQ(most_pieces({.pieces = 200, .coverage = 0.8f}), "120");
  EXPECT_EQ(most_pieces({.seconds = 60}), "120");
}

TEST(RefinedResult, ThereIsATrialForEachRegion) {
  EXPECT_EQ(key(relaxing_keys(result_of({}, 9), 0), "improve.trials"), "1");
  EXPECT_EQ(key(relaxing_keys(result_of({}, 9), 40), "improve.trials"), "40");
  EXPECT_EQ(key(relaxing_keys(result_of({}, 9, 3), 0), "improve.trials"), "3");
  EXPECT_EQ(key(relaxing_keys(result_of({}, 9, 3), 3), "improve.trials"), "3");
  EXPECT_EQ(test::message_of([] { relaxing_keys(result_of({}, 9, 3), 2); }),
            "--trials: found 2, allowed: 3 or more, one for each of the [[regions]]");
}

TEST(RefinedResult, ItsFolderIsOneTextWhateverItsName) {
  EXPECT_EQ(key(starting_keys(result_of({}, 9)), "start.pieces"), R"("out/a b")");
  EXPECT_EQ(key(starting_keys(result_of({}, 9)), "start.keep"), "free");
}

/// Pieces that an earlier refinement removed must not go again, because other pieces have their numbers by then.
TEST(RefinedResult, NothingOfAnEarlierRefinementIsLeft) {
  const std::vector<std::string> keys = starting_keys(result_of({}, 9));
  for (const char* list : {"start.remove", "start.lock", "start.not_anew"}) EXPECT_EQ(key(keys, list), "[]") << list;
}

TEST(RefinedResult, NoLimitOfWhatIsCoveredLeavesAHole) {
  EXPECT_EQ(key(erasing_keys(), "start.keep"), "standing");
  EXPECT_EQ(key(erasing_keys(), "stop.coverage"), "1");
  EXPECT_EQ(key(erasing_keys(), "stop.pieces"), "missing") << "other limits count as they did";
}

TEST(RefinedResult, WhatGoesMayBeMoreThanAnOverrideHolds) {
  RefinedResult result = result_of({}, 9);
  for (int i = 0; i < 30'000; ++i) result.erased.push_back(i);
  result.locked = {30'000};
  result.not_anew = {"a*[b]"};
  Job job;
  job.path = "job.toml";
  job.library = "/own.h5";
  job.start.pieces = "/old";
  job.start.keep = StartKeep::standing;
  const Job made = with_pieces_of(result, job);
  EXPECT_EQ(made.start.remove, result.erased);
  EXPECT_EQ(made.start.lock, result.locked);
  EXPECT_EQ(made.start.not_anew, result.not_anew);
  result.not_anew.assign(1000, std::string(2000, 'a'));
  EXPECT_NE(test::message_of([&] { with_pieces_of(result, job); }).find("larger than"), std::string::npos);
}

TEST(RefinedResult, ThoseWhosePiecesLieAboutSomewhereAreNotErased) {
  RefinedResult result = result_of({}, 2);
  const auto mistake = [&](bool exact) {
    const std::vector<PlacedPiece> all = {{"a", {}, false, true}, {"b", {}, false, exact}};
    return test::message_of([&] { check_can_be_erased(result, all); });
  };
  EXPECT_EQ(mistake(true), "");
  EXPECT_NE(mistake(false).find("out/a b: pieces.geojson does not say exactly where pieces lie"), std::string::npos);
  result.whole.job.settings.pieces.fit_all = true;
  EXPECT_EQ(mistake(true),
            "out/a b: its job has pieces.fit = \"all\", with sizes that follow from all pieces; allowed: --relax, "
            "--deform");
}

TEST(RefinedResult, GoesBesideIt) {
  EXPECT_EQ(folder_beside("out/animals", "-relaxed"), "out/animals-relaxed");
  EXPECT_EQ(folder_beside("out/animals//", "-relaxed"), "out/animals-relaxed");
  EXPECT_EQ(folder_beside("./out/../animals/", "-relaxed"), "animals-relaxed");
  EXPECT_EQ(folder_beside(".", "-relaxed"), std::filesystem::current_path().string() + "-relaxed");
  EXPECT_EQ(folder_beside("./", "-relaxed"), std::filesystem::current_path().string() + "-relaxed");
}

TEST(RefinedResult, ItsPiecesAreNotToBeOthers) {
  EXPECT_EQ(test::message_of([] { check_overrides({"seed=3", "start.grow=outward"}); }), "");
  EXPECT_EQ(
      test::message_of([] { check_overrides({"start.pieces = other"}); }),
      "--set start.pieces = other: the pieces come from RESULT; allowed: start.grow, and the keys of other sections");
  for (const char* key : {"start.keep=free", "start.remove=[1]", "start.lock=[]"}) {
    EXPECT_NE(test::message_of([&] { check_overrides({key}); }), "") << key;
  }
  EXPECT_EQ(test::message_of([] { check_overrides({"quality=good"}); }),
            "--set quality=good: no key to refine a result with; allowed: --relax --trials N, or improve.trials=N");
}

/// Results of an earlier version lack this information.
TEST(RefinedResult, SaysWhichPiecesAreLocked) {
  RefinedResult result = result_of({}, 9);
  result.whole.job.start.pieces = "earlier";
  result.whole.job.library = "/library.h5";
  result.whole.job.quality = QualityWord::none;
  result.whole.job.tables["given"] = {{{"shape", {{}, "disc"}}, {"at_px", {{10, 20}, ""}}, {"scale_px", {{30}, ""}}}};
  Job now = result.whole.job;
  now.settings.wishes.given.resize(2);
  const auto mistake = [&] {
    return test::message_of(
        [&] { check_is_the_same_collage(result, {.job = to_toml(now)}, now.settings.wishes.given); });
  };
  EXPECT_EQ(mistake(), "");
  now.settings.wishes.given[1].locked = false;
  EXPECT_EQ(mistake().substr(0, 62), "out/a b: pieces.geojson does not say which pieces are locked, ");
  result.whole.job.start.keep = StartKeep::free;
  EXPECT_EQ(mistake(), "") << "only those of [[given]] are";
}

}  // namespace test_refined_result
}  // namespace tessera::cli
