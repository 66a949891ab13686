// Silhouettes in colours of a palette: the colour of each piece, and pictures that show it.
#include <gtest/gtest.h>

#include <opencv2/core.hpp>
#include <set>

#include "render/piece_colours.h"
#include "support/drawn_collage.h"
#include "support/sample_collage.h"

namespace tessera {
namespace test_piece_colours {

const std::vector<std::string> kPalette{"#112233", "#aa0000", "#00bb00", "#0000cc"};

/// Discs of 40 px (45 px across) in rows, 46 px apart, so that each has up to four neighbours.
struct Discs : test::SampleCollage {
  explicit Discs(int count) {
    report.placements.clear();
    for (int i = 0; i < count; ++i)
      place(ShapeId{7}, 40, {30 + 46.f * float(i % 5), 30 + 46.f * float(i / 5)}, float(i));
  }
  std::vector<std::string> colours(const std::vector<std::string>& palette = kPalette) const {
    return piece_colours(report, report.placements, palette, 0);
  }
};

TEST(PieceColours, NeighboursDiffer) {
  const auto colours = Discs(25).colours();
  ASSERT_EQ(colours.size(), 25u);
  for (std::size_t i = 0; i < colours.size(); ++i) {
    EXPECT_TRUE(i % 5 == 4 || colours[i] != colours[i + 1]) << i;
    EXPECT_TRUE(i + 5 >= colours.size() || colours[i] != colours[i + 5]) << i;
  }
  EXPECT_EQ(std::set<std::string>(colours.begin(), colours.end()).size(), kPalette.size());
}

TEST(PieceColours, AreThoseOfThePictureThatPiecesShow) {
  Discs discs(3);
  discs.report.covered = {"#a01010", "#102030", ""};
  const auto colours = discs.colours();
  EXPECT_EQ(colours[0], "#aa0000");
  EXPECT_EQ(colours[1], "#112233");
  EXPECT_NE(colours[2], colours[1]) << "nothing is wished there: another one than its neighbour's";
}

TEST(PieceColours, AreNotChangedByLaterPieces) {
  const auto many = Discs(25).colours();
  const auto few = Discs(12).colours();
  EXPECT_TRUE(std::equal(few.begin(), few.end(), many.begin()));
}

TEST(PieceColours, OfAPieceTakenAwayReachesNeighboursAlone) {
  Discs discs(25);
  const auto before = discs.colours();
  discs.report.placements.erase(discs.report.placements.begin());
  const auto after = discs.colours();
  int changed = 0;
  for (std::size_t i = 0; i < after.size(); ++i) changed += after[i] != before[i + 1];
  EXPECT_LE(changed, 4);
}

TEST(PieceColours, FollowShapeAndPose) {
  std::set<std::string> seen;
  for (int i = 0; i < 20; ++i) {
    Discs alone(1);
    alone.report.placements[0].canvas_from_shape.tx += float(i);
    seen.insert(alone.colours()[0]);
  }
  EXPECT_EQ(seen.size(), kPalette.size());
}

TEST(PieceColours, OfASmallPaletteRepeatWhereTheyMust) {
  const auto one = Discs(9).colours({"#123456"});
  EXPECT_EQ(std::set<std::string>(one.begin(), one.end()), std::set<std::string>{"#123456"});
}

cv::Vec3b at_canvas(const cv::Mat& picture, float x, float y) { return picture.at<cv::Vec3b>(int(y * 2), int(x * 2)); }

TEST(PieceColours, AreSeenInPictureAndVectors) {
  test::SampleCollage collage;
  collage.report.colours = {"#aa0000", "#0000cc"};
  const cv::Mat picture = test::drawn_picture(collage.report);
  EXPECT_EQ(at_canvas(picture, 50, 50), cv::Vec3b(0, 0, 0xaa));
  EXPECT_EQ(at_canvas(picture, 140, 50), cv::Vec3b(0xc0, 0xe0, 0xff)) << "the hole of the ring";
  const std::string svg = test::drawn_svg(collage.report);
  EXPECT_NE(svg.find("<use xlink:href=\"#a0\" clip-path=\"url(#c0)\" fill=\"#aa0000\""), std::string::npos) << svg;
  EXPECT_NE(svg.find("fill=\"#0000cc\""), std::string::npos);
  const std::string symbol = svg.substr(svg.find("id=\"a0\""), 40);
  EXPECT_EQ(symbol.find("fill=\""), std::string::npos) << "the symbol must leave its colour to the piece: " << symbol;
}

TEST(PieceColours, StandForArtworkThatIsThere) {
  test::SampleCollage collage;
  test::embed_artwork(collage.report.shapes[0],
                      "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 10 10'>"
                      "<rect width='10' height='10' fill='lime'/></svg>",
                      10, 10, 5);
  EXPECT_EQ(at_canvas(test::drawn_picture(collage.report), 50, 50), cv::Vec3b(0, 255, 0));
  collage.report.colours = {"#aa0000", "#0000cc"};
  EXPECT_EQ(at_canvas(test::drawn_picture(collage.report), 50, 50), cv::Vec3b(0, 0, 0xaa));
  EXPECT_EQ(test::drawn_svg(collage.report).find("lime"), std::string::npos);
}

}  // namespace test_piece_colours
}  // namespace tessera
