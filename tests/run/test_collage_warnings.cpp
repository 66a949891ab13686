// The messages of tessera collage on stderr besides errors.
#include <gtest/gtest.h>

#include <functional>
#include <memory>

#include "core/base/stop.h"
#include "core/colour/colour_target.h"
#include "core/field/keep_out.h"
#include "run/messages/collage_warnings.h"
#include "run/messages/place_advice.h"
#include "run/messages/written_keys.h"
#include "support/synthetic_shapes.h"

namespace tessera::cli {
namespace test_collage_warnings {

TEST(EmptyResultWarning, says_what_keeps_pieces_out) {
  const Job job;
  EXPECT_EQ(
      empty_result_warning("out/a", WrittenKeys(job), {},
                           {"smaller pieces", "a larger canvas.size_px (now [1000, 1000])"}),
      "out/a: the collage is empty: nothing fits; try smaller pieces; a larger canvas.size_px (now [1000, 1000])");
  EXPECT_EQ(empty_result_warning("out/a", WrittenKeys(job), {}, {}).substr(0, 54),
            "out/a: the collage is empty: no shape may stand: weigh");
}

TEST(EmptyResultWarning, names_a_time_that_was_too_short) {
  Job job;
  job.settings.stop.seconds = 0.001;
  master::CollageResult result;
  result.statistics.stopped_by = StopReason::seconds;
  EXPECT_EQ(empty_result_warning("out/a", WrittenKeys(job), result, {}),
            "out/a: the collage is empty: stop.seconds (now 0.001) ended it before the first piece");
}

TEST(EmptyResultWarning, is_none_where_there_are_pieces_or_may_be_later) {
  const Job job;
  master::CollageResult result;
  result.unfinished = true;
  EXPECT_EQ(empty_result_warning("out/a", WrittenKeys(job), result, {}), "");
  result.unfinished = false;
  result.placements.resize(1);
  EXPECT_EQ(empty_result_warning("out/a", WrittenKeys(job), result, {}), "");
}

TEST(IncompleteWarning, SaysWhatAFinishedResultLacks) {
  ResultManifest manifest;
  manifest.finished = true;
  EXPECT_EQ(incomplete_warning("out/a", manifest), "out/a: the collage is empty; run.log says why");
  manifest.shapes.resize(3);
  EXPECT_EQ(incomplete_warning("out/a", manifest), "");
  manifest.missing = 1;
  EXPECT_EQ(incomplete_warning("out/a", manifest), "out/a: 1 piece is missing; card.txt names them");
  manifest.missing = 20;
  EXPECT_EQ(incomplete_warning("out/a", manifest), "out/a: 20 pieces are missing; card.txt names them");
}

TEST(WrittenKeys, LengthsAreInMmWhereTheCanvasHasASizeOnPaper) {
  Job job;
  EXPECT_EQ(WrittenKeys(job).with_value("pieces", "scale_px"), "pieces.scale_px (now [20, 160])");
  EXPECT_EQ(WrittenKeys(job).with_value("pieces", "padding_px"), "pieces.padding_px (now 0)");
  EXPECT_EQ(WrittenKeys(job).length_text(41.25), "41.2 px");
  job.canvas.width_mm = 200;
  job.canvas.height_mm = 200;
  EXPECT_EQ(WrittenKeys(job).with_value("pieces", "scale_px"), "pieces.scale_mm (now [4, 32])");
  EXPECT_EQ(WrittenKeys(job).with_value("pieces", "padding_px"), "pieces.padding_mm (now 0)");
  EXPECT_EQ(WrittenKeys(job).with_value("pieces", "uses"), "pieces.uses (now 0)");
  EXPECT_EQ(WrittenKeys(job).length_text(41.25), "8.25 mm");
}

TEST(WrittenKeys, RowsOfTablesHaveTheirNamesAndValues) {
  Job job;
  for (const char* name : {"sky", "land", "sea", "sand"}) {
    JobRow row;
    row["name"].text = name;
    if (std::string(name) != "land") row["scale_px"].numbers = {20, 160};
    job.tables["regions"].push_back(row);
  }
  JobRow cats;
  cats["names"].texts = {"cat*", "kitten"};
  cats["scale_px"].numbers = {180, 180};
  job.tables["shapes"] = {cats};
  const WrittenKeys keys(job);
  EXPECT_EQ(keys.rows_with("regions", "scale_px"), (std::vector<std::uint32_t>{0, 2, 3}));
  EXPECT_EQ(keys.rows_with_values("regions", "scale_px", {0, 2}),
            "scale_px of [[regions]] \"sky\" (now [20, 160]), \"sea\" (now [20, 160])");
  EXPECT_EQ(keys.rows_with_values("shapes", "scale_px", {0}), "scale_px of [[shapes]] \"cat*\", ... (now [180, 180])");
  EXPECT_EQ(keys.rows_with_values("shapes", "scale_px", {}), "");
  job.canvas.width_mm = job.canvas.height_mm = 200;
  EXPECT_EQ(keys.rows_with_values("regions", "scale_px", {0}), "scale_mm of [[regions]] \"sky\" (now [4, 32])");
}

/// [pieces] is not named if it decides for no shape.
TEST(PlaceAdvice, OnlyWhatDecidesIsNamed) {
  Job job;
  JobRow row;
  row["name"].text = "sky";
  row["scale_px"].numbers = {20, 160};
  job.tables["regions"] = {row};
  row.erase("scale_px");
  job.tables["regions"].push_back(row);
  Wishes wishes;
  wishes.regions.resize(2);
  wishes.regions[0].poses.scale_px = {{20, 160}};
  const std::string sky = "scale_px of [[regions]] \"sky\" (now [20, 160])", pieces = "pieces.scale_px (now [20, 160])";
  EXPECT_EQ(where_sizes_stand(WrittenKeys(job), wishes, {{ShapeId{0}}, {0}}), sky);
  EXPECT_EQ(where_sizes_stand(WrittenKeys(job), wishes, {{ShapeId{0}}, {1}}), pieces);
  EXPECT_EQ(where_sizes_stand(WrittenKeys(job), wishes, {{ShapeId{0}}, {0, 1}}), sky + " or " + pieces);
}

TEST(CollageWarnings, SizesThatDoNotRiseMayHaveDecimalCommas) {
  const auto warning = [](const std::string& text) {
    return decimal_comma_warning(job_from_toml("[library]\nfile = 'x.h5'\n" + text, "job.toml"));
  };
  EXPECT_EQ(
      warning("[pieces]\nscale_px = [30,5, 60,5]\n"),
      "pieces.scale_px = [30, 5, 60, 5] is 4 sizes, one after the other; where a decimal comma was meant, write a "
      "point: 30.5, not 30,5");
  EXPECT_EQ(warning("[pieces]\nscale_px = [20, 30, 60]\n"), "");
  EXPECT_EQ(warning("[pieces]\nrotation_deg = [-7,5, 7,5]\n").substr(0, 50),
            "pieces.rotation_deg = [-7, 5, 7, 5] is 4 angles, o");
  EXPECT_EQ(warning("[pieces]\nrotation_deg = [0, 90, 180, 270]\n"), "");
  EXPECT_EQ(warning("[pieces]\nscale_px = [30, 60]\n"), "");
  EXPECT_EQ(warning("[pieces]\nscale_px = [[60, 90], [20, 30], [10, 15]]\n"), "") << "intervals come in any order";
  const std::string row = "[[shapes]]\nnames = 'owl'\nscale_px = ";
  EXPECT_EQ(warning(row + "30\n" + row + "[40,5, 50]\n").substr(0, 52),
            "[[shapes]] 2: scale_px = [40, 5, 50] is 3 sizes, one");
}

TEST(CollageWarnings, KeysThatMeanNothingAreTold) {
  Job job;
  EXPECT_EQ(idle_keys_warning(job), "");
  job.settings.pieces.overlap_px = 0.5f;
  EXPECT_EQ(idle_keys_warning(job), "");
  job.settings.pieces.padding_px = 3;
  EXPECT_EQ(
      idle_keys_warning(job),
      "pieces.overlap_px (now 0.5) does not count beside pieces.padding_px (now 3), which keeps all pieces apart");
  job.output.dpi = 600;
  EXPECT_EQ(
      idle_keys_warning(job).substr(0, 140),
      "output.dpi (now 600) means nothing without a size on paper: output.width_mm, or canvas.size_mm; the picture is "
      "2000 px wide (output.width_px");
  job.settings.pieces.overlap_px = Job().settings.pieces.overlap_px;
  EXPECT_EQ(idle_keys_warning(job), idle_dpi_warning(job));
  job.output.width_mm = 100;
  EXPECT_EQ(idle_keys_warning(job), "");
  job.output.width_mm = 0;
  job.canvas.width_mm = 100;
  EXPECT_EQ(idle_keys_warning(job), "");
  job.settings.pieces.least_scale_px = 30;
  EXPECT_NE(idle_keys_warning(job).find("means nothing without pieces.fit = \"all\""), std::string::npos);
  job.settings.pieces.fit_all = true;
  EXPECT_EQ(idle_keys_warning(job), "");
}

TEST(CollageWarnings, AFactorOfABackgroundThatIsNoPictureIsTold) {
  Job job;
  job.output.background_light = 0.5;
  EXPECT_EQ(idle_keys_warning(job),
            "output.background_light (now 0.5) means nothing without output.background = \"image\"");
  EXPECT_EQ(idle_keys_warning(job), idle_light_warning(job));
  job.output.background = kImageBackground;
  EXPECT_EQ(idle_keys_warning(job), "");
}

TEST(CollageWarnings, KeysOfColourThatMeanNothingAreTold) {
  Job job;
  job.library_colours_within = 30;
  EXPECT_EQ(idle_keys_warning(job), "library.colours_within (now 30) means nothing without library.colours");
  job.library_colours = {"#ff0000"};
  EXPECT_EQ(idle_keys_warning(job), "");
  job.settings.colour.weight = 2;
  job.colour.shift = 8;
  EXPECT_EQ(idle_keys_warning(job),
            "colour.weight (now 2) means nothing without colour.image; colour.shift (now 8) means nothing without "
            "colour.image");
  EXPECT_EQ(idle_shift_warning(job), "colour.shift (now 8) means nothing without colour.image");
  job.colour.image = "/portrait.png";
  EXPECT_EQ(idle_keys_warning(job), "");
  EXPECT_EQ(idle_shift_warning(job), "");
}

TEST(CollageWarnings, LimitsOfDeformingThatMeanNothingAreTold) {
  Job job;
  job.settings.deform.most_px = 2;
  EXPECT_EQ(idle_keys_warning(job), "deform.most_px (now 2) means nothing without deform.kind = \"capped\"");
  job.settings.deform.kind = DeformKind::voronoi;
  EXPECT_NE(idle_keys_warning(job), "");
  job.settings.deform.kind = DeformKind::capped;
  EXPECT_EQ(idle_keys_warning(job), "");
}

TEST(CollageWarnings, ALibraryThatCannotShowAnImageIsTold) {
  Job job;
  EXPECT_EQ(unable_library_warning(job.colour, 5, true), "") << "there is no image";
  job.colour.image = "/portrait.png";
  EXPECT_EQ(unable_library_warning(job.colour, 50, false), "");
  EXPECT_EQ(unable_library_warning(job.colour, 49, false),
            "a library of 49 shapes has few colours to show colour.image, and few shapes to cover it with (3 to 40 "
            "shapes covered 78 to "
            "81 % of a picture, 419 covered 84); a photo needs 500 or more");
  EXPECT_EQ(unable_library_warning(job.colour, 500, true).substr(0, 86),
            "nearly all shapes of the library have one colour and cannot show colour.image; colour.");
  job.colour.pieces = "palette";
  EXPECT_EQ(unable_library_warning(job.colour, 5, true), "");
}

TEST(CollageWarnings, ALibraryThatIsUsedUpTellsSizesThatWouldFill) {
  PieceSettings pieces;
  pieces.min_scale_px = 20;
  pieces.max_scale_px = 100;
  master::CollageResult result;
  result.statistics.stopped_by = StopReason::full;
  result.placements.push_back({ShapeId{0}, {85, 0, 0, 0}, 0, 0});
  const auto canvas_px2 = [](double area_px2) {
    Canvas canvas;
    canvas.area_px2 = area_px2;
    return canvas;
  };
  EXPECT_EQ(used_up_warning(pieces, false, canvas_px2(34000), result), "");
  result.statistics.stopped_by = StopReason::used_up;
  EXPECT_EQ(used_up_warning(pieces, false, canvas_px2(34000), result),
            "the library is used up with 21 % of the canvas covered; pieces 2.0 times as large would fill it: "
            "pieces.scale_px = [40, 200], or pieces.fit = \"all\"; so would more uses (pieces.uses)");
  EXPECT_EQ(used_up_warning(pieces, true, canvas_px2(34000), result),
            "the library is used up with 21 % of the canvas covered; pieces 2.0 times as large would fill it: "
            "pieces.fit = \"all\"; so would more uses (pieces.uses)")
      << "nothing goes by pieces.scale_px where sizes are drawn";
  EXPECT_EQ(used_up_warning(pieces, false, canvas_px2(9000), result), "") << "hardly more is to be had";
  pieces.fit_all = true;
  EXPECT_EQ(used_up_warning(pieces, false, canvas_px2(34000), result), "") << "the program found these sizes";
}

TEST(CollageWarnings, WhyPiecesAreNotRelaxed) {
  const auto warning = [](float min_scale_px, float max_scale_px, const std::function<void(CollageSettings&)>& change) {
    CollageSettings settings;
    settings.pieces.min_scale_px = min_scale_px;
    settings.pieces.max_scale_px = max_scale_px;
    change(settings);
    return idle_relaxing_warning(settings);
  };
  const auto nothing = [](CollageSettings&) {};
  const std::string not_relaxed = "the pieces are not relaxed, as ";
  EXPECT_EQ(warning(20, 100, nothing), "");
  EXPECT_EQ(
      warning(20, 101, nothing),
      not_relaxed +
          "their sizes differ too much, 20 to 101 px (pieces.scale_px); allowed: a largest of 5 times the smallest");
  EXPECT_EQ(warning(50, 50, nothing),
            not_relaxed + "their sizes are fixed (pieces.scale_px, pieces.sizes, [[shapes]])");
  EXPECT_EQ(warning(20, 100, [](CollageSettings& s) { s.improve.relax = false; }),
            not_relaxed + "improve.relax is false");
  EXPECT_EQ(warning(20, 101, [](CollageSettings& s) { s.pieces.size_map = std::make_shared<SizeMap>(); }),
            not_relaxed + "their sizes depend on the place (pieces.size_map)");
  const auto show = [](CollageSettings& s) {
    s.colour.target = std::make_shared<ColourTarget>(Grid<Texel>(2, 2), 1.f);
  };
  EXPECT_EQ(warning(20, 101, show), not_relaxed + "they are chosen by what they cover (colour.image)");
}

TEST(CollageWarnings, RelaxingThatBringsNothingIsTold) {
  CollageSettings settings;
  settings.pieces.min_scale_px = 40;
  master::CollageResult result;
  result.statistics.trials = 2;
  EXPECT_EQ(nothing_gained_warning(settings, result),
            "no trial was an improvement, out of 2: the pieces have not moved; with more --trials pieces are "
            "exchanged, too");
  result.unfinished = true;
  EXPECT_EQ(nothing_gained_warning(settings, result), "");
  result.unfinished = false;
  result.statistics.trials_kept = 1;
  EXPECT_EQ(nothing_gained_warning(settings, result), "");
  result.statistics.trials_kept = 0;
  settings.improve.relax = false;
  EXPECT_EQ(nothing_gained_warning(settings, result), "") << "it was told before";
}

TEST(CollageWarnings, PiecesThatStandBadlyAreTold) {
  Shape square = test::make_test_shape("square", test::rectangle_outline(1, 1));
  const auto shape = [&](ShapeId) -> const Shape& { return square; };
  const auto piece = [](float x_px) { return GivenPiece{ShapeId{0}, {40, 0, x_px, 50}}; };
  Canvas canvas = make_rectangle_canvas(400, 100);
  take_out(distance_to({KeepOutRectangle{{200, 50}, {20, 20}}}, canvas), canvas);
  CollageSettings settings;
  settings.wishes.given = {piece(0), piece(10), piece(200)};
  EXPECT_EQ(standing_warning(settings, 3, StartKeep::locked, canvas, shape),
            "of [[given]] 1 lies in a zone that pieces keep out of, the first is number 2, \"square\"; they stand as "
            "they are")
      << "elsewhere they may lie";
  settings.wishes.given = {piece(60), piece(100), piece(140), piece(300), piece(310), piece(390), piece(315)};
  EXPECT_EQ(
      standing_warning(settings, 3, StartKeep::locked, canvas, shape),
      "of start.pieces 1 lies outside the canvas, the first is number 2, \"square\"; 2 lie on pieces before them, the "
      "first is number 1, \"square\"; they stand as they are");
  EXPECT_EQ(standing_warning(settings, 3, StartKeep::standing, canvas, shape),
            "of start.pieces 1 lies outside the canvas, the first is number 2, \"square\"; they stand as they are")
      << "a command that lets pieces stand means their overlaps";
  settings.wishes.given.resize(4);
  EXPECT_EQ(standing_warning(settings, 3, StartKeep::locked, canvas, shape), "");
}

}  // namespace test_collage_warnings
}  // namespace tessera::cli
