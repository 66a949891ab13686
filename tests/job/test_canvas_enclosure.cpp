// Detects canvases that consist only of an outline.
#include "job/canvas/canvas_enclosure.h"

#include <gtest/gtest.h>

#include <string>

#include "job/canvas/canvas_file.h"
#include "support/scratch_folder.h"

namespace tessera {
namespace test_canvas_enclosure {

class CanvasEnclosure : public testing::Test {
 protected:
  CanvasSpec spec(const std::string& body, int side_px) {
    const std::string text =
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"100\" height=\"100\">" + body + "</svg>";
    return {.width_px = side_px, .height_px = side_px, .file = folder_.write("canvas.svg", text)};
  }

  double covered(const std::string& body, int side_px = 300) { return covered_share(load_canvas(spec(body, side_px))); }

  test::ScratchFolder folder_;
};

std::string ring(double radius, double width) {
  return "<circle cx=\"50\" cy=\"50\" r=\"" + std::to_string(radius) +
         "\" fill=\"none\" stroke=\"black\" stroke-width=\"" + std::to_string(width) + "\"/>";
}

TEST_F(CanvasEnclosure, IsTheAreaOfARingInPartsOfItsDisc) {
  for (const int side_px : {100, 300, 2300}) {  // large canvases are searched on a coarser grid
    EXPECT_NEAR(covered(ring(40, 8), side_px), 1 - 36. * 36 / (44 * 44), 0.02) << side_px;
    EXPECT_NEAR(covered(ring(40, 2), side_px), 1 - 39. * 39 / (41 * 41), 0.02) << side_px;
  }
}

TEST_F(CanvasEnclosure, OutlinesAreToldFromRingsAndLetters) {
  EXPECT_LT(
      covered("<path d=\"M50 90 10 40l15-20 25 15 25-15 15 20z\" fill=\"none\" stroke=\"black\" stroke-width=\"2\"/>"),
      kMostCoveredByOutline);
  EXPECT_LT(
      covered("<rect x=\"5\" y=\"5\" width=\"90\" height=\"90\" fill=\"none\" stroke=\"black\" stroke-width=\"1\"/>"),
      kMostCoveredByOutline);
  EXPECT_GT(covered(ring(40, 8)), kMostCoveredByOutline);
  for (const char* letter : {"O", "B", "8", "A", "&amp;"}) {
    EXPECT_GT(covered("<text x=\"10\" y=\"85\" font-family=\"DejaVu Sans\" font-size=\"90\">" + std::string(letter) +
                      "</text>"),
              kMostCoveredByOutline)
        << letter;
  }
  EXPECT_GT(covered_share(load_canvas({.width_px = 64, .height_px = 64, .file = ""})), 0.9);
}

TEST_F(CanvasEnclosure, ZonesCountAsCovered) {
  CanvasSpec disc = spec("<circle cx=\"50\" cy=\"50\" r=\"45\"/>", 300);
  disc.keep_out_rectangles.push_back({.middle_px = {150, 150}, .half_size_px = {90, 90}});
  const Canvas canvas = load_canvas(disc);
  EXPECT_GT(covered_share(canvas), 0.95);
  EXPECT_GT(zones_part_of_enclosed(canvas), 0.95);
}

}  // namespace test_canvas_enclosure
}  // namespace tessera
