// colour.shift: the range of the tones, and the patches that it lays over a piece.
#include "render/pieces/tones.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "artwork/images/colour_conversion.h"
#include "core/colour/ciede2000.h"
#include "support/colours.h"
#include "support/sample_collage.h"

namespace tessera {
namespace test_tones {

/// The shapes' mean colour is a grey of lightness 60: #919191.
constexpr double kGrey = 145;

/// Two pieces, at x = 50 and x = 140 of 200.
struct Covering : test::SampleCollage {
  explicit Covering(std::vector<std::string> covered) { report.covered = std::move(covered); }

  /// Gives all shapes this grid.
  void paint(const ColourGrid& grid) {
    PlacedShapes shapes;
    for (const ShapeId id : {ShapeId{7}, ShapeId{3}}) {
      Shape shape = report.shape(id);
      shape.colour_grid = grid;
      shapes.add(id, shape);
    }
    report.shapes = shapes;
  }
};

std::vector<Tone> tones_of(const Covering& collage, const cv::Mat& picture, double most_difference) {
  std::vector<DrawnColours> drawn;
  for (std::size_t slot = 0; slot < collage.report.shapes.size(); ++slot) {
    drawn.push_back(drawn_colours(collage.report.shapes[slot]));
  }
  return tones_towards_picture(collage.report, drawn, picture, most_difference);
}

/// The colour of a cell after the patch is laid over it.
cv::Vec3d patched(const cv::Vec3d& bgr, const cv::Vec4b& over) {
  const double alpha = over[3] / 255.;
  return bgr * (1 - alpha) + cv::Vec3d(over[0], over[1], over[2]) * alpha;
}

double moved(const cv::Vec3d& own, const cv::Vec4b& over) {
  return double(ciede2000(lab_of(own), lab_of(patched(own, over))));
}

cv::Mat picture_of(const cv::Vec4b& left, const cv::Vec4b& right) {
  cv::Mat picture(50, 100, CV_8UC4, cv::Scalar(left));
  picture.colRange(50, 100).setTo(cv::Scalar(right));
  return picture;
}

TEST(Tones, GoAllTheWayWhereTheyMay) {
  const Covering collage({"#999d95", ""});
  const auto tones = tones_of(collage, {}, 8);
  ASSERT_EQ(tones.size(), 2u);
  for (const cv::Vec4b& cell : tones[0].patch.bgra) {
    EXPECT_LT(cv::norm(patched({kGrey, kGrey, kGrey}, cell) - cv::Vec3d(0x95, 0x9d, 0x99)), 1.5);
  }
  EXPECT_TRUE(tones[1].patch.empty()) << "nothing is wished there";
}

TEST(Tones, GoNoFurtherThanTheyMay) {
  const Covering collage({"#2040ff", "#000000"});
  for (const double most : {3., 6., 9.}) {
    for (const Tone& tone : tones_of(collage, {}, most)) {
      EXPECT_LE(moved({kGrey, kGrey, kGrey}, tone.patch.bgra[5]), most + 0.3) << "of rounding";
      EXPECT_GT(moved({kGrey, kGrey, kGrey}, tone.patch.bgra[5]), most - 0.6);
    }
  }
}

TEST(Tones, NeverHideTheDrawing) {
  const Covering collage({"#2040ff", "#000000"});
  for (const Tone& tone : tones_of(collage, {}, 100)) {
    for (const cv::Vec4b& cell : tone.patch.bgra) EXPECT_EQ(cell[3], 64) << "a quarter of 255";
  }
}

TEST(Tones, StartFromTheColourThatIsDrawn) {
  Covering collage({"#ff0000", "#808080"});
  collage.report.colours = {"#ff0000", "#808080"};
  for (const Tone& tone : tones_of(collage, {}, 20)) {
    EXPECT_TRUE(tone.patch.empty()) << "a silhouette in the colour of what it covers";
  }
}

TEST(Tones, OfNothingAreNone) {
  EXPECT_TRUE(tones_of(Covering({"#2040ff", "#000000"}), {}, 0).empty());
  EXPECT_TRUE(tones_of(Covering({}), {}, 8).empty());
}

/// A picture that is dark at the left of the first piece and light at its right.
TEST(Tones, FollowThePictureWithinAPiece) {
  Covering collage({"#919191", "#919191"});
  collage.report.placements[0].canvas_from_shape = {40, 0, 100, 50};
  collage.report.placements[1].canvas_from_shape = {-40, 0, 100, 50};  // upside down
  const cv::Mat picture = picture_of({120, 120, 120, 255}, {170, 170, 170, 255});
  const auto tones = tones_of(collage, picture, 5);
  const auto value = [&](int piece, int cell) {
    return patched({kGrey, kGrey, kGrey}, tones[std::size_t(piece)].patch.bgra[std::size_t(cell)])[1];
  };
  for (const int row : {0, 1, 2, 3}) {
    EXPECT_LT(value(0, 4 * row), kGrey - 5);
    EXPECT_GT(value(0, 4 * row + 3), kGrey + 5);
    EXPECT_GT(value(1, 4 * row), kGrey + 5);
    EXPECT_LT(value(1, 4 * row + 3), kGrey - 5);
  }
}

TEST(Tones, GoTowardsThePictureFromEachCellsOwnColour) {
  Covering collage({"#919191", "#919191"});
  collage.paint(test::two_toned_grid({55, 0, 0}, {65, 0, 0}));
  const auto tones = tones_of(collage, picture_of({145, 145, 145, 255}, {145, 145, 145, 255}), 6);
  const TonePatch& patch = tones[0].patch;
  EXPECT_GT(patched({130, 130, 130}, patch.bgra[4])[1], 131);
  EXPECT_LT(patched({158, 158, 158}, patch.bgra[7])[1], 157);
}

TEST(Tones, WishNothingWhereThePictureIsTransparent) {
  const Covering collage({"#919191", "#919191"});
  const auto tones = tones_of(collage, picture_of({0, 0, 0, 255}, {255, 255, 255, 0}), 6);
  EXPECT_FALSE(tones[0].patch.empty());
  EXPECT_TRUE(tones[1].patch.empty());
}

/// A strong patch would veil black lines on white without need.
TEST(Tones, OfAShortWayAreHardlySeen) {
  Covering collage({"#ffffff", "#fafafa"});
  collage.report.colours = {"#fefefe", "#ffffff"};
  const auto tones = tones_of(collage, {}, 20);
  for (const cv::Vec4b& cell : tones[0].patch.bgra) EXPECT_LE(cell[3], 7);
  for (const cv::Vec4b& cell : tones[1].patch.bgra) {
    EXPECT_LE(cell[3], 32);
    EXPECT_NEAR(patched({255, 255, 255}, cell)[1], 250, 1);
  }
}

/// The right half has hardly any drawing on it, in a colour of its own.
TEST(Tones, OfCellsThatAreHardlyDrawnOnFollowTheOthers) {
  Covering collage({"#919191", "#919191"});
  ColourGrid grid;
  for (int cell = 0; cell < kColourCells; ++cell) {
    const bool left = cell % kColourSide < 2;
    test::paint(grid, cell, left ? Lab{60, 0, 0} : Lab{10, 0, 0}, left ? 255 : 1);
  }
  collage.paint(grid);
  const auto patch = tones_of(collage, picture_of({150, 150, 150, 255}, {150, 150, 150, 255}), 20)[0].patch;
  EXPECT_NEAR(patched({kGrey, kGrey, kGrey}, patch.bgra[6])[1], 150, 3) << "beside the drawn half";
}

TEST(Tones, OfAnOutlineWithoutAreaAreNone) {
  Covering collage({"#ff0000", "#ff0000"});
  PlacedShapes shapes;
  for (const ShapeId id : {ShapeId{7}, ShapeId{3}}) {
    Shape shape = collage.report.shape(id);
    for (Vec2& p : shape.outline.curves.front()) p.y = 0;
    shapes.add(id, shape);
  }
  collage.report.shapes = shapes;
  for (const Tone& tone : tones_of(collage, picture_of({0, 0, 0, 255}, {0, 0, 0, 255}), 6)) {
    EXPECT_TRUE(tone.patch.empty());
  }
}

/// A damaged library may place a piece anywhere.
TEST(Tones, OfAPieceFarAwayGoByThePicturesEdge) {
  Covering collage({"#ff0000", "#ff0000"});
  collage.report.placements[0].canvas_from_shape = {40, 0, 1e30f, -1e30f};
  const auto tones = tones_of(collage, picture_of({0, 0, 0, 255}, {255, 255, 255, 255}), 6);
  EXPECT_GT(patched({kGrey, kGrey, kGrey}, tones[0].patch.bgra[0])[0], kGrey);
}

RC_GTEST_PROP(Tones, OfAnyColoursStayWithinTheirLimits, ()) {
  const auto byte = [] { return *rc::gen::inRange(0, 256); };
  Covering collage({"#808080", "#808080"});
  ColourGrid grid;
  for (int cell = 0; cell < kColourCells; ++cell) {
    const Lab lab = lab_of(cv::Vec3d(byte(), byte(), byte()));
    test::paint(grid, cell, lab, *rc::gen::element(0, 1, 128, 255));
  }
  collage.paint(grid);
  const cv::Mat picture = picture_of(cv::Vec4b(std::uint8_t(byte()), std::uint8_t(byte()), std::uint8_t(byte()), 255),
                                     cv::Vec4b(std::uint8_t(byte()), std::uint8_t(byte()), std::uint8_t(byte()), 255));
  for (const Tone& tone : tones_of(collage, picture, 100)) {
    for (const cv::Vec4b& cell : tone.patch.bgra) RC_ASSERT(cell[3] <= 64);
  }
}

TEST(Tones, KnowWhatPiecesCover) {
  Covering collage({});
  collage.paint(test::two_toned_grid({50, 0, 0}, {50, 0, 0}));
  const auto target =
      test::picture(200, 100, [](Vec2 p) { return p.x < 95 ? test::opaque(lab_of(cv::Vec3d(0, 0, 255))) : Texel{}; });
  const std::vector<std::string> covered = covered_colours(collage.report.placements, collage.report.shapes, *target);
  ASSERT_EQ(covered.size(), 2u);
  EXPECT_TRUE(covered[0] == "#ff0000" || covered[0] == "#fe0000" || covered[0] == "#ff0100") << covered[0];
  EXPECT_EQ(covered[1], "");
}

}  // namespace test_tones
}  // namespace tessera
