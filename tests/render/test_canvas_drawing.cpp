// Before a run, the program checks that the canvas' files can be drawn at the end.
#include "render/canvas_drawing.h"

#include <gtest/gtest.h>

#include <chrono>

#include "job/canvas/canvas_file.h"
#include "support/input_error.h"
#include "support/sample_collage.h"
#include "support/scratch_folder.h"

namespace tessera {
namespace test_canvas_drawing {

/// A canvas of 60 x 60 px, or a keep-out zone, that draws fast at 120 px but takes half a minute at 4096 px.
struct SlowlyDrawn : test::SampleCollage {
  SlowlyDrawn() {
    const std::string svg =
        R"~(<svg xmlns="http://www.w3.org/2000/svg" width="1000" height="1000"><filter id="f" filterUnits="userSpaceOnUse" )~"
        R"~(x="0" y="0" width="1000" height="1000"><feMorphology operator="dilate" radius="300"/></filter>)~"
        R"~(<circle cx="500" cy="500" r="100" filter="url(#f)"/></svg>)~";
    file = folder.write("slow.svg", svg);
    job.canvas = {.width_px = 60, .height_px = 60, .file = ""};
  }

  /// The message of check_canvas_drawing. Expects that it comes soon.
  std::string message() {
    const Canvas loaded = load_canvas(job.canvas);
    const auto start = std::chrono::steady_clock::now();
    const std::string text = test::message_of([&] { check_canvas_drawing(job.canvas, report.output, loaded, 1); });
    EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(20));
    return text;
  }

  test::ScratchFolder folder;
  std::string file;
};

TEST(CanvasDrawing, ACanvasThatCanNeverBeDrawnIsRefused) {
  SlowlyDrawn collage;
  collage.job.canvas.file = collage.file;
  EXPECT_EQ(collage.message(), "canvas.file: " + collage.file +
                                   ": took longer than 1 s; the pictures need it 4096 px large or larger: make the "
                                   "drawing simpler, above all its filters");
}

TEST(CanvasDrawing, SoIsWhatIsKeptOutOfWherePicturesShowIt) {
  SlowlyDrawn collage;
  collage.job.canvas.keep_out = collage.file;
  collage.report.output.keep_out = "artwork";
  const std::string text = collage.message();
  EXPECT_EQ(text.find("canvas.keep_out: " + collage.file + ": took longer than 1 s; "), 0u) << text;
  EXPECT_NE(text.find("or give output.keep_out = \"none\""), std::string::npos) << text;
  collage.report.output.keep_out = kNoKeepOut;
  EXPECT_EQ(collage.message(), "");
}

TEST(CanvasDrawing, ARectangleNeedsNothing) {
  SlowlyDrawn collage;
  EXPECT_EQ(collage.message(), "");
}

}  // namespace test_canvas_drawing
}  // namespace tessera
