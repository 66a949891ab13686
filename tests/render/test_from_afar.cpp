// The likeness of a mosaic to its picture from afar: from bands of pixels to the figures of a card.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <opencv2/imgproc.hpp>

#include "core/base/error.h"
#include "job/canvas/overlays.h"
#include "render/afar_measure.h"
#include "render/card_drawing.h"
#include "render/pieces/tones.h"
#include "result/card_input.h"
#include "result/folder/result_file.h"
#include "support/images.h"
#include "support/input_error.h"
#include "support/sample_collage.h"
#include "support/scratch_folder.h"

namespace tessera {
namespace test_from_afar {

/// A smooth picture in straight BGRA.
cv::Mat gradient(cv::Size size) {
  cv::Mat picture(size, CV_8UC4);
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) {
      picture.at<cv::Vec4b>(y, x) = {std::uint8_t(255 * x / size.width), std::uint8_t(255 * y / size.height), 90, 255};
    }
  }
  return picture;
}

cv::Mat without_alpha(const cv::Mat& bgra) {
  cv::Mat bgr;
  cv::cvtColor(bgra, bgr, cv::COLOR_BGRA2BGR);
  return bgr;
}

Grid<Srgb> cells_in_bands(const cv::Mat& picture, int rows) {
  MosaicCells cells(picture.size());
  for (int y = 0; y < picture.rows; y += rows) cells.write(picture.rowRange(y, std::min(y + rows, picture.rows)));
  cells.finish();
  return cells.cells();
}

AfarFigures figures(const cv::Mat& mosaic, const cv::Mat& picture, const Canvas* canvas = nullptr) {
  const auto wanted = cells_of_picture(picture, comparison_cells(mosaic.size()));
  return figures_from_afar(picture_pair(cells_in_bands(mosaic, mosaic.rows), wanted, canvas), 100).value();
}

TEST(ComparisonCells, AreAMillionOrAsManyAsThePixels) {
  EXPECT_EQ(comparison_cells({64, 40}), cv::Size(64, 40));
  EXPECT_EQ(comparison_cells({4000, 1000}), cv::Size(2000, 500));
  EXPECT_EQ(comparison_cells({60000, 1}), cv::Size(60000, 1));
  EXPECT_EQ(comparison_cells({60000, 2}), cv::Size(60000, 2));
}

TEST(MosaicCells, DoNotDependOnTheBands) {
  const cv::Mat picture = gradient({1300, 1100});
  const Grid<Srgb> whole = cells_in_bands(picture, 1100);
  EXPECT_EQ(whole.data(), cells_in_bands(picture, 64).data());
  EXPECT_EQ(whole.data(), cells_in_bands(without_alpha(picture), 7).data());
}

TEST(FromAfar, AnotherSizeOfThePictureIsThePicture) {
  const AfarFigures seen = figures(without_alpha(gradient({1500, 1000})), gradient({450, 300}));
  EXPECT_LT(seen.colour_difference, 0.2);
  EXPECT_GT(seen.structure, 0.999);
}

TEST(FromAfar, WhatIsTransparentInTheMosaicIsWhite) {
  cv::Mat mosaic = gradient({200, 100}), on_white = without_alpha(mosaic);
  mosaic.colRange(0, 100).setTo(cv::Scalar(0, 0, 0, 0));
  on_white.colRange(0, 100).setTo(cv::Scalar::all(255));
  EXPECT_EQ(cells_in_bands(mosaic, 100).data(), cells_in_bands(on_white, 100).data());
}

TEST(FromAfar, WhatIsTransparentInThePictureDoesNotCount) {
  cv::Mat mosaic = gradient({200, 100}), picture = mosaic.clone();
  mosaic.colRange(0, 90).setTo(cv::Scalar(0, 0, 255, 255));
  EXPECT_GT(figures(mosaic, picture).colour_difference, 10);
  for (int y = 0; y < 100; ++y) {
    for (int x = 0; x < 90; ++x) picture.at<cv::Vec4b>(y, x)[3] = 0;
  }
  const AfarFigures seen = figures(mosaic, picture);
  EXPECT_EQ(seen.colour_difference, 0);
  EXPECT_NEAR(seen.structure, 1, 1e-9);
}

TEST(FromAfar, OnlyTheCanvasCounts) {
  Grid<float> coverage(400, 200, 0.f);  // the right half of a canvas of 200 x 100 px
  for (int y = 0; y < 200; ++y) std::fill(coverage.row(y) + 200, coverage.row(y) + 400, 1.f);
  const Canvas right_half = make_mask_canvas(coverage);
  const cv::Mat picture = gradient({400, 200});
  cv::Mat mosaic = picture.clone();
  mosaic.colRange(0, 196).setTo(cv::Scalar::all(255));
  EXPECT_GT(figures(mosaic, picture).colour_difference, 10);
  EXPECT_LT(figures(mosaic, picture, &right_half).colour_difference, 0.01);
  mosaic.colRange(196, 400).setTo(cv::Scalar::all(255));
  EXPECT_GT(figures(mosaic, picture, &right_half).colour_difference, 10);
}

TEST(FromAfar, ACanvasOfHundredPiecesIsTenPiecesWide) {
  EXPECT_NEAR(width_in_pieces(make_rectangle_canvas(500, 500), 100), 10, 1e-6);
  EXPECT_EQ(width_in_pieces(make_rectangle_canvas(500, 500), 0), 0);
}

class Measured : public testing::Test {
 protected:
  Measured() {
    const std::vector<std::uint8_t> bytes = test::encoded(picture_, ".png");
    image_ = folder_.write("picture.png", std::string(bytes.begin(), bytes.end()));
  }

  AfarNote note(const cv::Mat& drawn) {
    AfarMeasure measure(sample_.report, image_, smallest_px_, drawers_);
    measure.rows().write(drawn);
    measure.rows().finish();
    return measure.note();
  }

  std::string image_;
  std::optional<float> smallest_px_ = 16;
  const cv::Mat picture_ = gradient({600, 300});
  const test::ScratchFolder folder_;
  Drawers drawers_{photo_drawer_settings(1)};
  test::SampleCollage sample_;  // two pieces on 200 x 100 px, drawn 400 px wide
};

TEST_F(Measured, APictureOfThePictureIsEqual) {
  const AfarNote found = note(without_alpha(gradient({400, 200})));
  ASSERT_TRUE(found.seen) << found.not_measured;
  EXPECT_EQ(found.seen->at_100_px.height_px, 50);
  EXPECT_LT(found.seen->at_100_px.colour_difference, 0.2);
  EXPECT_EQ(found.seen->at_piece_size.value().width_px, 2);
  const AfarNote white = note(cv::Mat(200, 400, CV_8UC3, cv::Scalar::all(255)));
  EXPECT_GT(white.seen.value().at_100_px.colour_difference, 20);
}

TEST_F(Measured, ALostPictureIsSaidWithoutItsPath) {
  std::filesystem::remove(image_);
  const AfarNote found = note(without_alpha(gradient({400, 200})));
  EXPECT_FALSE(found.seen);
  EXPECT_EQ(found.not_measured, "colour.image cannot be read any more");
}

TEST_F(Measured, AnotherPictureThanThatOfTheCollageIsNotMeasured) {
  sample_.report.covered = covered_colours(sample_.report.placements, sample_.report.shapes,
                                           *read_colour_image(sample_.canvas, image_, *smallest_px_, drawers_).target);
  EXPECT_TRUE(note(without_alpha(gradient({400, 200}))).seen);
  sample_.report.covered.back() = "#123456";
  EXPECT_EQ(note(without_alpha(gradient({400, 200}))).not_measured, "colour.image has changed since the collage");
}

TEST_F(Measured, PiecesOfUnknownSizesAreSaid) {
  smallest_px_.reset();
  EXPECT_EQ(note(without_alpha(gradient({400, 200}))).not_measured,
            "the pieces that the collage began from cannot be read any more");
}

TEST_F(Measured, CardsKeepTheFiguresOfTheLatestPixels) {
  const std::string dir = folder_.path("");
  const std::string card = publish_result(dir, sample_.report, sample_.source(), true);
  EXPECT_FALSE(read_card(dir).afar) << "before it is drawn";
  DrawingNotes notes{.pieces = 2};
  notes.afar = AfarNote{SeenFromAfar{{100, 50, 5.70249, 0.7034}, AfarFigures{40, 20, 3.5, 0.9}}, {}};
  const std::string lines =
      "Seen from afar\n  100 px wide             colour 5.70 (CIEDE2000), structure 0.703 (SSIM)\n"
      "  40 px wide              colour 3.50 (CIEDE2000), structure 0.900 (SSIM)\n"
      "                          (one px for a piece of mean size)\n";
  const std::string drawing = "Drawing\n  drawing time            0.0 s\n";
  for (int i = 0; i < 2; ++i) add_drawing_to_cards(dir, notes);
  add_drawing_to_cards(dir, {.pieces = 2});
  EXPECT_EQ(read_result_file(dir, "card.txt"), card + lines + drawing);
  const auto read = read_card(dir).afar.value();
  EXPECT_EQ(read.at_100_px.colour_difference, 5.702);
  EXPECT_EQ(read.at_100_px.structure, 0.703);
  EXPECT_EQ(read.at_piece_size.value().width_px, 40);

  notes.afar = AfarNote{{}, "colour.image cannot be read any more"};
  add_drawing_to_cards(dir, notes);
  EXPECT_EQ(read_result_file(dir, "card.txt"),
            card + "Seen from afar\n  not measured            colour.image cannot be read any more\n" + drawing);
  EXPECT_FALSE(read_card(dir).afar);
}

TEST_F(Measured, ForgedFiguresAreRefused) {
  const std::string dir = folder_.path("");
  publish_result(dir, sample_.report, sample_.source(), true);
  const auto whole = nlohmann::json::parse(read_result_file(dir, "card.json"));
  const auto message = [&](const std::string& section) {
    auto card = whole;
    card["from_afar"] = nlohmann::json::parse(section);
    folder_.write("card.json", card.dump());
    return test::message_of([&] { read_card(dir); });
  };
  const std::string path = path_in_result(dir, "card.json") + ": from_afar: ";
  EXPECT_EQ(message("3"), path + "at_100_px.width_px is missing; allowed: a card.json of tessera collage");
  EXPECT_EQ(message(R"({"at_100_px": {"width_px": 100, "height_px": 50, "ciede2000": 1e9, "ssim": 1}})"),
            path + "at_100_px.ciede2000: found 1000000000.0, allowed: a number from 0 to 200");
  EXPECT_EQ(message(R"({"at_100_px": {"width_px": 100, "height_px": 50, "ciede2000": 1, "ssim": -2}})"),
            path + "at_100_px.ssim: found -2, allowed: a number from -1 to 1");
  EXPECT_EQ(message(R"({"at_100_px": {"width_px": 0, "height_px": 50, "ciede2000": 1, "ssim": 1}})"),
            path + "at_100_px.width_px: found 0, allowed: a number from 1 to 1000000");
}

}  // namespace test_from_afar
}  // namespace tessera
