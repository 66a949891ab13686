// Scenes with partly hidden silhouettes: the hidden share, the visible curves, the scoring of answers, and a whole run.
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "bench/benchmarks.h"
#include "bench/scenes/answer_measures.h"
#include "bench/scenes/changed_outline.h"
#include "bench/scenes/left_out.h"
#include "bench/scenes/scene.h"
#include "bench/scenes/scene_queries.h"
#include "bench/scenes/scene_success.h"
#include "bench/scenes/verdicts.h"
#include "blocking_silhouettes.h"
#include "core/base/error.h"
#include "core/geometry/closed_curve.h"
#include "core/geometry/polygon.h"
#include "support/scratch_folder.h"

namespace tessera::bench {
namespace test_scenes {

cv::Mat blob(std::uint64_t number) { return largest_part(test::blob_mask(number)); }

bool same_masks(const cv::Mat& a, const cv::Mat& b) { return a.size() == b.size() && cv::countNonZero(a != b) == 0; }

Scene made(const std::string& kind, double hidden, std::uint64_t seed) {
  Draws draws(seed);
  if (kind == "clipped") return clipped_scene(blob(seed), hidden);
  if (kind == "bars") return bars_scene(blob(seed), hidden, draws);
  if (kind == "branch") return branch_scene(blob(seed), hidden, draws);
  return covered_scene(blob(seed), blob(seed + 1), hidden, 1.2, draws).value();
}

TEST(Scenes, HideTheStatedPartOfTheArea) {
  for (const std::string kind : {"covered", "bars", "branch"}) {
    for (const double hidden : {0.2, 0.5, 0.7}) {
      for (std::uint64_t seed = 1; seed <= 3; ++seed) {
        const Scene scene = made(kind, hidden, seed);
        EXPECT_NEAR(scene.hidden(), hidden, 0.01) << kind << ", seed " << seed;
        EXPECT_EQ(cv::countNonZero(scene.lower), cv::countNonZero(blob(seed))) << "the silhouette itself is whole";
        EXPECT_NEAR(cv::countNonZero(scene.seen()), (1 - scene.hidden()) * cv::countNonZero(scene.lower), 1);
        EXPECT_EQ(cv::countNonZero(scene.united()), cv::countNonZero(scene.seen()) + cv::countNonZero(scene.hider));
      }
    }
  }
}

TEST(Scenes, AreTheSameForTheSameSeed) {
  for (const std::string kind : {"covered", "bars", "branch"}) {
    EXPECT_TRUE(same_masks(made(kind, 0.4, 5).hider, made(kind, 0.4, 5).hider)) << kind;
    EXPECT_FALSE(same_masks(made(kind, 0.4, 5).hider, made(kind, 0.4, 6).hider)) << kind;
  }
}

TEST(Scenes, AClippedSilhouetteLosesALeftPartOfItsWidth) {
  const Scene scene = made("clipped", 0.4, 2);
  const cv::Rect whole = cv::boundingRect(scene.lower);
  const cv::Rect seen = cv::boundingRect(scene.seen());
  EXPECT_NEAR(seen.width, 0.6 * whole.width, 1);
  EXPECT_EQ(seen.x + seen.width, whole.x + whole.width);
}

/// The upper silhouette is seen whole; the scene's frame cuts off none of it.
TEST(Scenes, ShowTheUpperSilhouetteWhole) {
  Draws draws(3);
  const Scene scene = covered_scene(blob(1), blob(2), 0.2, 1.3, draws).value();
  const cv::Rect upper = cv::boundingRect(scene.hider);
  EXPECT_TRUE(upper.x > 0 && upper.y > 0);
  EXPECT_TRUE(upper.x + upper.width < scene.hider.cols && upper.y + upper.height < scene.hider.rows);
  const double growth = double(cv::countNonZero(scene.hider)) / cv::countNonZero(scene.lower);
  EXPECT_NEAR(growth, 1.3, 0.05);
}

TEST(Scenes, AThinLineCannotHideMost) {
  cv::Mat line(400, 400, CV_8U, cv::Scalar(0));
  line(cv::Rect(10, 200, 380, 4)).setTo(255);
  Draws draws(1);
  EXPECT_FALSE(covered_scene(blob(1), line, 0.6, 1, draws));
}

TEST(Scenes, TheDistanceFromTheHiderIsThatFromItsEdge) {
  Scene scene{cv::Mat(50, 80, CV_8U, cv::Scalar(255)), cv::Mat(50, 80, CV_8U, cv::Scalar(0))};
  scene.hider.colRange(0, 30).setTo(255);
  const HiderDistance distance = distance_from_hider(scene);
  EXPECT_NEAR(distance({29.5f, 20}), 0, 0.51) << "the edge between two pixels";
  EXPECT_NEAR(distance({40, 20}), 10.5, 0.01);
  EXPECT_LT(distance({10, 20}), 0);
  EXPECT_LT(distance({-5, -5}), 0) << "beyond the mask as at its rim";
}

TEST(ChangedOutline, KeepsTheStatedPart) {
  const std::vector<Vec2> outline = outer_outline(blob(1));
  const std::vector<Vec2> other = outer_outline(blob(2));
  for (const double part : {0.2, 0.5, 0.7}) {
    Draws draws(9);
    const ChangedOutline changed = changed_outline(outline, other, part, draws).value();
    const Curve kept{{changed.points.begin(), changed.points.begin() + std::ptrdiff_t(changed.kept)}, false};
    EXPECT_NEAR(length_of(kept) / closed_length(resampled_closed(outline, 512)), 1 - part, 0.01);
    EXPECT_GT(signed_area(changed.points), 0);

    // The mask has the same boundary as the points.
    const std::vector<Vec2> traced = outer_outline(filled_mask(changed.points));
    EXPECT_NEAR(signed_area(traced), signed_area(changed.points), 0.02 * signed_area(changed.points));

    Draws again(9);
    EXPECT_EQ(changed_outline(outline, other, part, again)->points, changed.points);
  }
}

TEST(ChangedOutline, LeavesTheOldCourse) {
  const std::vector<Vec2> outline = outer_outline(blob(1));
  Draws draws(2);
  const ChangedOutline changed = changed_outline(outline, outer_outline(blob(2)), 0.3, draws).value();
  double farthest = 0;
  for (std::size_t i = changed.kept; i < changed.points.size(); ++i) {
    float nearest = 1000;
    for (const Vec2 p : outline) nearest = std::min(nearest, norm(p - changed.points[i]));
    farthest = std::max(farthest, double(nearest));
  }
  EXPECT_GT(farthest, 5);
  EXPECT_FALSE(changed_outline(outline, outline, 0.01, draws)) << "so short an arc cannot leave it";
}

std::vector<Silhouette> named_silhouettes(const std::vector<std::string>& names) {
  std::vector<Silhouette> silhouettes;
  for (const std::string& name : names) silhouettes.push_back({name, {}});
  return silhouettes;
}

TEST(LeftOutSilhouettes, AreHalfOfTheClasses) {
  const auto silhouettes = named_silhouettes({"a-1", "a-2", "b-1", "c-1", "c-2", "d-1"});
  const std::vector<bool> left_out = chosen_left_out(silhouettes, {}, LeftOut::classes, 1);
  EXPECT_EQ(left_out[0], left_out[1]);
  EXPECT_EQ(left_out[3], left_out[4]);
  EXPECT_EQ(int(left_out[0]) + int(left_out[2]) + int(left_out[3]) + int(left_out[5]), 2);
  EXPECT_EQ(left_out, chosen_left_out(silhouettes, {}, LeftOut::classes, 1));
  const std::vector<bool> none = chosen_left_out(silhouettes, {}, LeftOut::none, 1);
  EXPECT_EQ(std::count(none.begin(), none.end(), true), 0);
}

TEST(LeftOutSilhouettes, AreHalfOfTheShapesOfEachClassAndTwinsShareTheirLot) {
  const auto silhouettes = named_silhouettes({"a-1", "a-2", "a-3", "a-4", "b-1", "b-2"});
  const Twins twins("a-1 a-3\na-2 ~a-4", "t.txt", silhouettes);
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    const std::vector<bool> left_out = chosen_left_out(silhouettes, twins, LeftOut::shapes, seed);
    EXPECT_EQ(left_out[0], left_out[2]) << seed;
    EXPECT_EQ(left_out[1], left_out[3]) << "the library may hold mirror images; " << seed;
    EXPECT_NE(left_out[4], left_out[5]) << seed;
  }
}

TEST(LeftOutSilhouettes, AreRemovedFromTheLibraryWithTheirMirrorImages) {
  SilhouetteLibrary library;
  for (std::size_t i = 0; i < 6; ++i) library.shapes.push_back({.silhouette = i / 2, .mirrored = i % 2 == 1});
  leave_out({true, false, true}, library);
  ASSERT_EQ(library.shapes.size(), 2u);
  EXPECT_EQ(library.shapes[0].silhouette, 1u);
}

TEST(SceneSuccess, CountsTheHiddenSilhouetteAndAllThatIsShown) {
  SilhouetteLibrary library;
  for (std::size_t i = 0; i < 4; ++i) library.shapes.push_back({.silhouette = i});
  library.shapes.push_back({.silhouette = 0, .mirrored = true});
  const Twins twins("a b", "t.txt", named_silhouettes({"a", "b", "c", "d"}));

  const SceneSuccess itself = scene_success({0, 3}, {0, 2}, library, twins);
  EXPECT_TRUE(itself.told && itself.itself && itself.twin && itself.any && itself.among && !itself.all_among);
  const SceneSuccess twin = scene_success({1, 2}, {0, 2}, library, twins);
  EXPECT_TRUE(!twin.itself && twin.twin && twin.any && twin.among && twin.all_among);
  const SceneSuccess upper_first = scene_success({2, 3, 0}, {0, 2}, library, twins);
  EXPECT_TRUE(!upper_first.twin && upper_first.any && upper_first.among && upper_first.all_among);
  const SceneSuccess mirrored = scene_success({4}, {0}, library, twins);
  EXPECT_TRUE(mirrored.told && !mirrored.twin && !mirrored.any && !mirrored.among);
  const Twins mirrors("a ~a", "t.txt", named_silhouettes({"a", "b", "c"}));
  const SceneSuccess symmetric = scene_success({4}, {0}, library, mirrors);
  EXPECT_TRUE(symmetric.twin && symmetric.any && symmetric.among && !symmetric.itself);
  const SceneSuccess nothing = scene_success({}, {0}, library, twins);
  EXPECT_TRUE(!nothing.told && !nothing.among && !nothing.all_among);
}

/// Four queries of known shapes (one answer is wrong, one is missing), and two queries of unknown shapes.
const std::vector<Verdict> kVerdicts = {
    {.measure = 0.9, .told = true, .right = true, .known = true},
    {.measure = 0.6, .told = true, .right = true, .known = true},
    {.measure = 0.5, .told = true, .right = false, .known = true},
    {.measure = 0, .told = false, .right = false, .known = true},
    {.measure = 0.7, .told = true, .right = false, .known = false},
    {.measure = 0.2, .told = true, .right = false, .known = false},
};

TEST(PrecisionRecall, CountsAnswersAboveTheThreshold) {
  const PrecisionRecall all = precision_recall(kVerdicts, 0);
  EXPECT_DOUBLE_EQ(all.precision(), 2 / 5.);
  EXPECT_DOUBLE_EQ(all.recall(), 2 / 4.);
  EXPECT_DOUBLE_EQ(all.f1(), 2 * 0.4 * 0.5 / (0.4 + 0.5));
  const PrecisionRecall some = precision_recall(kVerdicts, 0.6);
  EXPECT_DOUBLE_EQ(some.precision(), 2 / 3.) << "an answer of just the threshold is given";
  EXPECT_DOUBLE_EQ(some.recall(), 2 / 4.);
  const PrecisionRecall few = precision_recall(kVerdicts, 0.8);
  EXPECT_DOUBLE_EQ(few.precision(), 1);
  EXPECT_DOUBLE_EQ(few.recall(), 1 / 4.);
}

TEST(PrecisionRecall, WithoutAnswersNothingIsWrong) {
  EXPECT_DOUBLE_EQ(precision_recall(kVerdicts, 2).precision(), 1);
  EXPECT_DOUBLE_EQ(precision_recall(kVerdicts, 2).recall(), 0);
  EXPECT_DOUBLE_EQ(precision_recall({}, 0).f1(), 0);
  EXPECT_DOUBLE_EQ(precision_recall({}, 0).recall(), 1);
}

TEST(PrecisionRecall, TheBestThresholdHasTheLargestF1) {
  EXPECT_DOUBLE_EQ(best_threshold(kVerdicts).least, 0.6);
  EXPECT_DOUBLE_EQ(best_threshold(kVerdicts).f1(), 2 * 2. / (3 + 4));
  EXPECT_DOUBLE_EQ(best_threshold({}).f1(), 0);
}

TEST(AnswerMeasures, CompareTheBestAnswerWithTheNextShapeAndWithItsOwnLength) {
  SilhouetteLibrary library;
  for (std::size_t i = 0; i < 3; ++i) library.shapes.push_back({.silhouette = i});
  library.shapes[0].outline.curves = {{{0, 0}, {2, 0}, {2, 2}, {0, 2}}};  // perimeter 8
  const Twins twins("a b", "t.txt", named_silhouettes({"a", "b", "c"}));
  const Similarity four_times{0, 4, 0, 0};
  const std::vector<Recognition> found = {
      {ShapeId{0}, four_times, 0.6f, 18}, {ShapeId{1}, {}, 0.55f}, {ShapeId{2}, {}, 0.25f}};
  const AnswerMeasures measures = answer_measures(found, library, twins);
  EXPECT_NEAR(measures.similarity, 0.6, 1e-6);
  EXPECT_NEAR(measures.margin, 0.35, 1e-6) << "over the first that is no twin";
  EXPECT_NEAR(measures.score, 0.6 * std::sqrt(18 / 32.), 1e-6);
  EXPECT_NEAR(answer_measures({found[0], found[1]}, library, twins).margin, 0.6, 1e-6);
  EXPECT_EQ(answer_measures({}, library, twins).score, 0);
}

SilhouetteCase blob_case(int count) {
  SilhouetteCase run;
  for (int i = 0; i < count; ++i) run.silhouettes.push_back({"blob-" + std::to_string(i), blob(std::uint64_t(i))});
  return run;
}

TEST(SceneQueries, HaveTheirTruthAndRepeat) {
  const SilhouetteCase run = blob_case(4);
  for (const std::string& kind : scene_kinds()) {
    const SceneQuery query = scene_query(run, kind, 1, 50, {2, 3}).value();
    ASSERT_FALSE(query.query.curves.empty()) << kind;
    const bool shows_two = kind == "union" || kind == "changed";
    EXPECT_EQ(query.shown.size(), shows_two ? 2u : 1u) << kind;
    EXPECT_EQ(query.shown.front(), 1u);
    const auto closed =
        std::count_if(query.query.curves.begin(), query.query.curves.end(), [](const Curve& c) { return c.closed; });
    EXPECT_EQ(closed, shows_two ? std::ptrdiff_t(query.query.curves.size()) : 0) << kind << ": known edges are cut out";
    EXPECT_EQ(scene_query(run, kind, 1, 50, {2, 3})->query.curves, query.query.curves) << kind;
  }
  EXPECT_FALSE(scene_query(run, "union", 1, 50, {})) << "nothing to lay over it";
}

Setting quick_setting(const test::ScratchFolder& folder) {
  return {.quick = true, .devices = "all", .out = folder.path("scenes.json")};
}

ScenesOptions blob_options(const test::ScratchFolder& folder, int count) {
  test::write_blobs(folder, count);
  ScenesOptions options;
  options.shapes = folder.path("");
  return options;
}

TEST(ScenesBenchmark, FindsBlobsInAllScenes) {
  const test::ScratchFolder folder;
  const ScenesOptions options = blob_options(folder, 6);
  const Report report = bench_scenes(quick_setting(folder), options);
  EXPECT_EQ(report.json.at("benchmark"), "scenes");
  const Json& rows = report.json.at("rows");
  ASSERT_EQ(rows.size(), scene_kinds().size());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    EXPECT_EQ(rows[i].at("scene"), scene_kinds()[i]);
    EXPECT_EQ(rows[i].at("hidden_percent"), 50);
    EXPECT_EQ(rows[i].at("queries"), 6);
    EXPECT_GT(rows[i].at("shown_percent").get<double>(), 65) << report.text;
    EXPECT_GE(rows[i].at("among_ten_percent").get<double>(), rows[i].at("twin_percent").get<double>());
  }
  EXPECT_FALSE(report.json.contains("thresholds"));
  for (const char* ending : {"svg", "png"}) {
    EXPECT_GT(std::filesystem::file_size(folder.path("scenes." + std::string(ending))), 100u);
  }
}

TEST(ScenesBenchmark, TellsPrecisionAndRecallWhereShapesAreLeftOut) {
  const test::ScratchFolder folder;
  ScenesOptions options = blob_options(folder, 8);
  options.kinds = {"clipped"};
  options.hidden = {20};
  options.left_out = "shapes";
  const Report report = bench_scenes(quick_setting(folder), options);
  EXPECT_EQ(report.json.at("library_shapes"), 4);
  EXPECT_EQ(report.json.at("rows")[0].at("queries"), 4) << "success counts shapes that the library has";
  const Json& thresholds = report.json.at("thresholds");
  ASSERT_GT(thresholds.size(), 5u);
  for (const char* measure : {"score", "similarity"}) {
    const Json& first = thresholds[0].at(measure);
    EXPECT_GT(first.at("recall_percent").get<double>(), 70) << report.text;
    EXPECT_LT(first.at("precision_percent").get<double>(), 60) << "half of the queries are unknown";
    EXPECT_EQ(thresholds.back().at(measure).at("least"), 0.95);
  }
  EXPECT_GT(report.json.at("best").at("score").at("f1_percent").get<double>(), 80) << report.text;
  EXPECT_GT(report.json.at("best").at("similarity").at("f1_percent").get<double>(), 80) << report.text;
}

std::string complaint(ScenesOptions options, const test::ScratchFolder& folder) {
  options.shapes = folder.path("");
  try {
    bench_scenes(quick_setting(folder), options);
  } catch (const InputError& error) {
    return error.what();
  }
  return "none";
}

TEST(ScenesBenchmark, RefusesWhatItCannotDo) {
  const test::ScratchFolder folder;
  EXPECT_NE(complaint({}, folder).find("--shapes: found no PNG in"), std::string::npos);
  ScenesOptions options;
  options.kinds = {"union", "fog"};
  EXPECT_EQ(complaint(options, folder),
            "--kinds: found \"fog\"; allowed: clipped, covered, bars, branch, union, changed");
  options = {};
  options.hidden = {50, 0};
  EXPECT_EQ(complaint(options, folder), "--hidden: found 0; allowed: 1 to 90 %");
  options.hidden = {91};
  EXPECT_EQ(complaint(options, folder), "--hidden: found 91; allowed: 1 to 90 %");
  options = {};
  options.left_out = "some";
  EXPECT_EQ(complaint(options, folder), "--left-out: found \"some\"; allowed: none, classes, shapes");
  options = {};
  options.noise_px = -1;
  EXPECT_EQ(complaint(options, folder), "--noise: found -1; allowed: 0 to 20 px");
  options = {};
  options.jpeg_quality = 101;
  EXPECT_EQ(complaint(options, folder), "--jpeg: found 101; allowed: 1 to 100, or 0 for none");
}

}  // namespace test_scenes
}  // namespace tessera::bench
