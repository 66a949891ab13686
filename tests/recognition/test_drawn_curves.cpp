// Curves of SVGs and images: outlines with holes and centre lines, in the drawing's units; and files without curves.
#include "recognition/drawn_curves.h"

#include <gtest/gtest.h>

#include <opencv2/imgproc.hpp>

#include "core/base/error.h"
#include "core/geometry/polygon.h"
#include "recognition/match_picture.h"
#include "recognition/match_text.h"
#include "support/images.h"
#include "support/scratch_folder.h"

namespace tessera {
namespace test_drawn_curves {

class DrawnCurvesOf : public testing::Test {
 protected:
  std::string svg(const std::string& body) {
    return folder_.write("a.svg",
                         "<svg xmlns='http://www.w3.org/2000/svg' width='200' height='100'>" + body + "</svg>");
  }
  std::string png(const cv::Mat& image) {
    const std::vector<std::uint8_t> bytes = test::encoded(image, ".png");
    return folder_.write("a.png", std::string(bytes.begin(), bytes.end()));
  }
  DrawnCurves read(const std::string& path, TracedAs kind) {
    Drawers drawers({});
    return read_drawn_curves(path, kind, drawers);
  }
  std::string mistake(const std::string& path, TracedAs kind) {
    try {
      read(path, kind);
    } catch (const InputError& error) {
      return error.what();
    }
    return "no mistake found";
  }

  test::ScratchFolder folder_;
};

TEST_F(DrawnCurvesOf, OutlinesHaveHolesAndTheDrawingsUnits) {
  const std::string ring = svg("<path fill-rule='evenodd' d='M20 20 H180 V80 H20Z M60 40 H140 V60 H60Z'/>");
  const DrawnCurves drawn = read(ring, TracedAs::outlines);
  ASSERT_EQ(drawn.curves.size(), 2u);
  EXPECT_NEAR(drawn.pixel, 200.f / 1024, 1e-4);
  EXPECT_NEAR(signed_area(drawn.curves[0].points), 160 * 60, 30);
  EXPECT_NEAR(signed_area(drawn.curves[1].points), -80 * 20, 30);
  EXPECT_TRUE(drawn.curves[0].closed && drawn.curves[1].closed);
}

TEST_F(DrawnCurvesOf, AMaskGivesTheSameOutline) {
  cv::Mat mask = cv::Mat::zeros(100, 200, CV_8UC3);
  cv::rectangle(mask, {20, 20}, {179, 79}, {255, 255, 255}, cv::FILLED);
  const DrawnCurves drawn = read(png(mask), TracedAs::outlines);
  ASSERT_EQ(drawn.curves.size(), 1u);
  EXPECT_EQ(drawn.pixel, 1) << "an enlarged image shows no more than its own pixels";
  EXPECT_NEAR(signed_area(drawn.curves[0].points), 160 * 60, 60);
}

TEST_F(DrawnCurvesOf, CentreLinesAreThoseOfStrokes) {
  const std::string body = "<path d='M20 50 H180' stroke='black' stroke-width='6'/>";
  for (const std::string ground : {"", "<rect width='200' height='100' fill='#ffe'/>"}) {
    const DrawnCurves drawn = read(svg(ground + body), TracedAs::centre_lines);
    ASSERT_EQ(drawn.curves.size(), 1u) << ground;
    EXPECT_FALSE(drawn.curves[0].closed);
    EXPECT_NEAR(length_of(drawn.curves[0]), 160, 7);
    for (const Vec2 p : drawn.curves[0].points) EXPECT_NEAR(p.y, 50, 0.3);
  }
}

TEST_F(DrawnCurvesOf, ALineDrawingThatEnclosesGroundIsNotFilled) {
  cv::Mat drawing(200, 200, CV_8UC3, cv::Scalar(255, 255, 255));
  cv::circle(drawing, {100, 100}, 60, {40, 40, 160}, 4, cv::LINE_AA);
  cv::circle(drawing, {100, 100}, 30, {160, 40, 40}, 4, cv::LINE_AA);
  const DrawnCurves drawn = read(png(drawing), TracedAs::centre_lines);
  ASSERT_EQ(drawn.curves.size(), 2u);
  EXPECT_NEAR(length_of(drawn.curves[0]), 2 * 3.1416 * 60, 4);
  EXPECT_NEAR(length_of(drawn.curves[1]), 2 * 3.1416 * 30, 4);
}

TEST_F(DrawnCurvesOf, ASolidSquareHasAnOutlineAndNoLines) {
  const std::string square = svg("<rect x='60' y='10' width='80' height='80'/>");
  EXPECT_EQ(read(square, TracedAs::outlines).curves.size(), 1u);
  EXPECT_NE(mistake(square, TracedAs::centre_lines).find("found no lines"), std::string::npos);
}

TEST_F(DrawnCurvesOf, FilesWithoutCurvesAreNamed) {
  EXPECT_NE(mistake(svg(""), TracedAs::outlines).find("a.svg: found nothing that is drawn; needed: an opaque"),
            std::string::npos);
  EXPECT_NE(mistake(svg("<path d='M5 5'/>"), TracedAs::centre_lines).find("a.svg: found no lines; needed: lines"),
            std::string::npos);
  EXPECT_NE(mistake(folder_.path("none.svg"), TracedAs::outlines).find("none.svg"), std::string::npos);
  EXPECT_NE(mistake(folder_.write("empty.svg", ""), TracedAs::outlines).find("empty.svg: neither SVG nor"),
            std::string::npos);
}

TEST(MatchText, TellsRunsAndPicturesThem) {
  const Curve line{{{0, 0}, {100, 0}}, false};
  const std::vector<CurveMatch> matches = matched_curves({{line}}, {{line}}, 1);
  ASSERT_EQ(matches.size(), 1u);
  const std::string json = match_json("a \"b\".svg", "c.svg", matches);
  EXPECT_NE(json.find("\"a\": \"a \\\"b\\\".svg\""), std::string::npos);
  EXPECT_NE(json.find("\"runs\": ["), std::string::npos);
  EXPECT_NE(match_table(matches).find("score"), std::string::npos);
  const std::string picture = match_picture({line}, {line}, matches);
  EXPECT_EQ(picture.rfind("<svg", 0), 0u);
  EXPECT_NE(picture.find("#d55e00"), std::string::npos);
}

}  // namespace test_drawn_curves
}  // namespace tessera
