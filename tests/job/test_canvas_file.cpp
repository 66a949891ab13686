// Canvases from masks: the filled part, the size in the box, and files that leave nothing to fill.
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "core/base/error.h"
#include "job/canvas/canvas_edge.h"
#include "job/canvas/canvas_file.h"
#include "job/canvas/canvas_page.h"
#include "support/images.h"
#include "support/scratch_folder.h"

namespace tessera {
namespace test_canvas_file {

class CanvasFile : public testing::Test {
 protected:
  std::string svg(const std::string& body, const std::string& size = "width=\"100\" height=\"50\"") {
    return folder_.write("mask.svg", "<svg xmlns=\"http://www.w3.org/2000/svg\" " + size + ">" + body + "</svg>");
  }

  std::string png(const cv::Mat& image) {
    const std::vector<std::uint8_t> bytes = test::encoded(image, ".png");
    return folder_.write("mask.png", std::string(bytes.begin(), bytes.end()));
  }

  std::string mistake(const CanvasSpec& spec) {
    try {
      load_canvas(spec);
    } catch (const InputError& error) {
      return error.what();
    }
    return "no mistake found";
  }

  test::ScratchFolder folder_;
};

/// The signed distance at the node nearest to (x, y), in canvas px.
float distance_at(const Canvas& canvas, float x, float y) {
  const CanvasField& field = canvas.distance;
  return field.value(int(std::lround(x - field.origin.x)), int(std::lround(y - field.origin.y)));
}

TEST_F(CanvasFile, without_file_it_is_a_rectangle) {
  const Canvas canvas = load_canvas({.width_px = 120, .height_px = 80, .file = ""});
  EXPECT_EQ(canvas.width_px, 120);
  EXPECT_EQ(canvas.height_px, 80);
  EXPECT_EQ(canvas.area_px2, 120 * 80);
}

TEST_F(CanvasFile, opaque_part_of_an_svg_is_filled_and_holes_stay_free) {
  const Canvas canvas = load_canvas(
      {.width_px = 200,
       .height_px = 200,
       .file = svg("<path fill-rule=\"evenodd\" d=\"M10 5h80v40h-80z M40 15v20h20v-20z\" fill=\"yellow\"/>")});
  EXPECT_EQ(canvas.width_px, 200);
  EXPECT_EQ(canvas.height_px, 100);
  EXPECT_NEAR(canvas.area_px2, (80 * 40 - 20 * 20) * 4, 20);
  EXPECT_NEAR(distance_at(canvas, 50, 50), 30, 1);    // 30 px from the left side and from the hole
  EXPECT_NEAR(distance_at(canvas, 100, 50), -20, 1);  // the middle of the hole
  EXPECT_LT(distance_at(canvas, 5, 50), 0);
}

TEST_F(CanvasFile, aspect_is_kept_in_the_box) {
  const std::string file = svg("<circle r=\"20\" cx=\"50\" cy=\"25\"/>");
  const Canvas wide = load_canvas({.width_px = 64, .height_px = 1000, .file = file});
  EXPECT_EQ(wide.width_px, 64);
  EXPECT_EQ(wide.height_px, 32);
  const Canvas low = load_canvas({.width_px = 1000, .height_px = 64, .file = file});
  EXPECT_EQ(low.width_px, 128);
  EXPECT_EQ(low.height_px, 64);
}

TEST_F(CanvasFile, opaque_svg_is_filled_where_it_differs_from_its_background) {
  const Canvas canvas = load_canvas(
      {.width_px = 200,
       .height_px = 100,
       .file = svg("<rect width=\"100\" height=\"50\" fill=\"white\"/><circle r=\"20\" cx=\"50\" cy=\"25\"/>")});
  EXPECT_NEAR(canvas.area_px2, 3.1416 * 40 * 40, 30);
  EXPECT_NEAR(distance_at(canvas, 100, 50), 40, 1);
}

TEST_F(CanvasFile, translucent_parts_of_an_svg_are_filled) {
  const auto area = [&](const std::string& body) {
    return load_canvas({.width_px = 200, .height_px = 100, .file = svg(body)}).area_px2;
  };
  const std::string body = "<rect x=\"30\" y=\"10\" width=\"40\" height=\"30\"/>";
  EXPECT_NEAR(area("<rect x=\"10\" y=\"20\" width=\"80\" height=\"10\" fill-opacity=\"0.4\"/>" + body), 6400, 30);
  EXPECT_NEAR(area("<circle cx=\"50\" cy=\"25\" r=\"20\" opacity=\"0.4\"/>"), 3.1416 * 40 * 40, 30);
}

TEST_F(CanvasFile, black_on_white_and_white_on_black_images_are_masks) {
  cv::Mat image(60, 90, CV_8UC1, cv::Scalar(255));
  cv::rectangle(image, {30, 20, 30, 20}, cv::Scalar(0), cv::FILLED);
  const auto area = [&](const cv::Mat& mask) {
    return load_canvas({.width_px = 90, .height_px = 60, .file = png(mask)}).area_px2;
  };
  EXPECT_NEAR(area(image), 600, 30);
  EXPECT_NEAR(area(~image), 600, 30);
}

TEST_F(CanvasFile, alpha_of_an_image_is_a_mask) {
  cv::Mat image(100, 100, CV_8UC4, cv::Scalar(255, 255, 255, 0));
  cv::circle(image, {50, 50}, 30, cv::Scalar(0, 0, 255, 255), cv::FILLED);
  const Canvas canvas = load_canvas({.width_px = 100, .height_px = 100, .file = png(image)});
  EXPECT_NEAR(canvas.area_px2, 2821, 30);
}

/// 420 x 297 mm give 2000 x 1414.286 px. A page of that aspect must not lose width because of the 0.286 px.
TEST_F(CanvasFile, fills_a_box_on_paper_to_its_last_mm) {
  CanvasSpec spec{.width_px = 2000,
                  .height_px = 1414,
                  .file = svg("<ellipse cx=\"210\" cy=\"148.5\" rx=\"208\" ry=\"146\"/>",
                              "width=\"420mm\" height=\"297mm\" viewBox=\"0 0 420 297\"")};
  spec.width_mm = 420;
  spec.height_mm = 297;
  Drawers drawers(canvas_drawer_settings(spec));
  const Canvas canvas = load_canvas(spec, drawers);
  EXPECT_EQ(canvas.width_px, 2000);
  EXPECT_EQ(canvas.height_px, 1414);
  EXPECT_NEAR(canvas.area_px2, 3.14159 * 208 * 146 * (2000. / 420) * (2000. / 420), 1000);
  shrink_box_to_page(spec, canvas, drawers);
  EXPECT_NEAR(spec.width_mm, 420, 1e-4);
  EXPECT_NEAR(spec.height_mm, 297, 1e-4);
}

TEST_F(CanvasFile, has_the_mm_of_the_side_that_fits_and_the_pages_aspect) {
  const auto paper_mm = [&](int width_px, int height_px, double width_mm, double height_mm) {
    CanvasSpec spec{.width_px = width_px,
                    .height_px = height_px,
                    .file = svg("<circle cx=\"45\" cy=\"30\" r=\"28\"/>", "width=\"90\" height=\"60\"")};
    spec.width_mm = width_mm;
    spec.height_mm = height_mm;
    Drawers drawers(canvas_drawer_settings(spec));
    const Canvas canvas = load_canvas(spec, drawers);
    shrink_box_to_page(spec, canvas, drawers);
    EXPECT_EQ(spec.width_px, canvas.width_px);
    EXPECT_EQ(spec.height_px, canvas.height_px);
    return cv::Size2d(spec.width_mm, spec.height_mm);
  };
  const auto expect_near = [](const cv::Size2d& found, double width_mm, double height_mm) {
    EXPECT_NEAR(found.width, width_mm, 1e-4);
    EXPECT_NEAR(found.height, height_mm, 1e-4);
  };
  expect_near(paper_mm(2000, 1333, 300, 200), 300, 200);
  expect_near(paper_mm(1414, 2000, 210, 297), 210, 140);
  expect_near(paper_mm(400, 200, 400, 200), 300, 200);
  expect_near(paper_mm(6000, 4000, 150, 100), 150, 100);
}

TEST_F(CanvasFile, coverage_has_even_sides) {
  const CanvasPage page{cv::Mat(31, 45, CV_8UC4, cv::Scalar(0, 0, 0, 0)), 23, 16, 2};
  const Grid<float> coverage = coverage_on_canvas(page, mask_coverage(page.bgra));
  EXPECT_EQ(coverage.width(), 46);
  EXPECT_EQ(coverage.height(), 32);
}

TEST_F(CanvasFile, heart_of_the_example_job_has_area) {
  const Canvas canvas =
      load_canvas({.width_px = 300, .height_px = 300, .file = TESSERA_SOURCE_DIR "/jobs/canvas/heart.svg"});
  EXPECT_EQ(canvas.width_px, 300);
  EXPECT_EQ(canvas.height_px, 270);
  EXPECT_GT(canvas.area_px2, 0.5 * 300 * 270);
}

std::vector<std::vector<Vec2>> edge_of(const CanvasSpec& spec) {
  Drawers drawers(canvas_drawer_settings(spec));
  return canvas_edge(spec, drawers).curves;
}

TEST_F(CanvasFile, the_edge_for_pictures_is_the_drawings_own) {
  const auto edge = edge_of({.width_px = 200,
                             .height_px = 300,
                             .file = svg("<path fill-rule=\"evenodd\" "
                                         "d=\"M10 5h80v40h-80z M38 25a12 12 0 0 0 24 0a12 12 0 0 0 -24 0z\"/>")});
  ASSERT_EQ(edge.size(), 2u);  // the rectangle, and the hole in it
  double farthest = 0;
  for (std::size_t i = 0; i < edge[1].size(); ++i) {
    const Vec2 p = edge[1][i];
    const Vec2 next = edge[1][(i + 1) % edge[1].size()];
    farthest = std::max(farthest, std::abs(std::hypot(p.x - 100., p.y - 50.) - 24));
    farthest = std::max(farthest, std::abs(std::hypot((p.x + next.x) / 2 - 100., (p.y + next.y) / 2 - 50.) - 24));
  }
  EXPECT_LT(farthest, 0.01);  // canvas px; a tenth of a px of a picture ten times as large
  for (const Vec2 p : edge[0]) {
    const bool at_side = std::min(std::abs(p.x - 20), std::abs(p.x - 180)) < 0.1f;
    const bool above_or_below = std::min(std::abs(p.y - 10), std::abs(p.y - 90)) < 0.1f;
    EXPECT_TRUE(at_side || above_or_below) << p.x << " " << p.y;
  }
}

TEST_F(CanvasFile, the_edge_ends_at_the_page) {
  const auto edge = edge_of({.width_px = 40, .height_px = 40, .file = svg("<rect width=\"50\" height=\"50\"/>")});
  ASSERT_EQ(edge.size(), 1u);
  float left = 99, right = 0, top = 99, bottom = 0;
  for (const Vec2 p : edge[0]) {
    left = std::min(left, p.x), right = std::max(right, p.x), top = std::min(top, p.y), bottom = std::max(bottom, p.y);
  }
  EXPECT_NEAR(left, 0, 0.01);
  EXPECT_NEAR(right, 20, 0.01);
  EXPECT_NEAR(top, 0, 0.01);
  EXPECT_NEAR(bottom, 20, 0.01);
}

TEST_F(CanvasFile, a_rectangle_has_no_edge_of_its_own) { EXPECT_TRUE(edge_of({}).empty()); }

TEST_F(CanvasFile, nothing_to_fill_is_a_mistake) {
  const CanvasSpec empty{.width_px = 100, .height_px = 100, .file = svg("")};
  EXPECT_NE(mistake(empty).find("no area to fill"), std::string::npos);
  const cv::Mat grey(50, 50, CV_8UC3, cv::Scalar(128, 128, 128));
  EXPECT_NE(mistake({.width_px = 100, .height_px = 100, .file = png(grey)}).find("no area to fill"), std::string::npos);
}

TEST_F(CanvasFile, unusable_files_and_sizes_are_mistakes) {
  EXPECT_NE(mistake({.width_px = 99, .height_px = 99, .file = folder_.path("none.svg")}).find("none.svg"),
            std::string::npos);
  EXPECT_NE(mistake({.width_px = 99, .height_px = 99, .file = folder_.write("a.png", "no image")}).find("a.png"),
            std::string::npos);
  const std::string ribbon = svg("<rect width=\"9000\" height=\"9\"/>", "width=\"9000\" height=\"9\"");
  EXPECT_NE(mistake({.width_px = 500, .height_px = 500, .file = ribbon}).find("16 px or more"), std::string::npos);
  EXPECT_NE(mistake({.width_px = 9000, .height_px = 500, .file = ribbon}).find("only 9000 x 10 px"), std::string::npos);
}

TEST_F(CanvasFile, mistakes_of_a_job_name_it) {
  Job job;
  job.path = "poster.toml";
  job.canvas = {.width_px = 99, .height_px = 99, .file = folder_.path("none.svg")};
  try {
    canvas_of(job);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_TRUE(std::string(error.what()).starts_with("poster.toml: canvas.file: ")) << error.what();
  }
}

TEST_F(CanvasFile, only_regular_files_are_opened) {
  const std::string pipe = folder_.path("pipe.svg");
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  const CanvasSpec from_pipe{.width_px = 99, .height_px = 99, .file = pipe};  // would wait for a writer
  EXPECT_EQ(mistake(from_pipe),
            "canvas.file: " + pipe + ": not a readable file: found a pipe, allowed: a regular file");
  EXPECT_NE(mistake({.width_px = 99, .height_px = 99, .file = "/dev/zero"}).find("found a device"), std::string::npos);
  EXPECT_NE(mistake({.width_px = 99, .height_px = 99, .file = folder_.path("")}).find("found a folder"),
            std::string::npos);
}

TEST_F(CanvasFile, large_canvases_fit_into_the_memory_of_a_drawing) {
  const std::string file = svg("<circle r=\"20\" cx=\"25\" cy=\"25\"/>", "width=\"50\" height=\"50\"");
  const Canvas canvas = load_canvas({.width_px = 4096, .height_px = 4096, .file = file});
  EXPECT_NEAR(double(canvas.area_px2) / (4096. * 4096), 3.1416 * 20 * 20 / 2500, 0.001);
}

/// Beyond the size limit of drawings, the page is drawn smaller and its edge is interpolated.
TEST_F(CanvasFile, may_be_as_large_as_a_rectangle) {
  const std::string file =
      svg("<rect x=\"10\" y=\"1\" width=\"1000\" height=\"11\"/>"
          "<circle r=\"3\" cx=\"200\" cy=\"7\" fill=\"red\"/>",
          "width=\"1020\" height=\"13\"");
  const CanvasSpec spec{.width_px = 20000, .height_px = 5000, .file = file};
  const Canvas canvas = load_canvas(spec);
  EXPECT_EQ(canvas.width_px, 20000);
  EXPECT_NEAR(canvas.height_px, 20000 * 13 / 1020., 2);
  const double unit_px = 20000 / 1020.;
  EXPECT_NEAR(canvas.area_px2 / (1000 * 11 * unit_px * unit_px), 1, 0.005);
  const float middle_px = float(canvas.height_px) / 2;
  EXPECT_NEAR(distance_at(canvas, float(20 * unit_px), middle_px), 5.5 * unit_px, 1.5);
  EXPECT_NEAR(distance_at(canvas, float(12 * unit_px), middle_px), 2 * unit_px, 1.5);
  EXPECT_NEAR(distance_at(canvas, float(7 * unit_px), middle_px), -3 * unit_px, 1.5);
  const auto edge = edge_of(spec);
  ASSERT_EQ(edge.size(), 1u);
  for (const Vec2 p : edge[0]) {
    const double to_side = std::min(std::abs(p.x - 10 * unit_px), std::abs(p.x - 1010 * unit_px));
    const double to_ends = std::min(std::abs(p.y - 1 * unit_px), std::abs(p.y - 12 * unit_px));
    EXPECT_LT(std::min(to_side, to_ends), 2) << p.x << " " << p.y;
  }
}

/// The limit of a drawing also applies to its box at twice the resolution.
TEST_F(CanvasFile, fits_a_large_box_by_its_shorter_side) {
  const std::string file = svg("<circle r=\"20\" cx=\"25\" cy=\"25\"/>", "width=\"50\" height=\"50\"");
  const Canvas canvas = load_canvas({.width_px = 12000, .height_px = 300, .file = file});
  EXPECT_EQ(canvas.width_px, 300);
  EXPECT_EQ(canvas.height_px, 300);
  EXPECT_NEAR(canvas.area_px2, 3.1416 * 120 * 120, 100);
}

/// Red above green above blue, on a transparent ground.
const char* const kStripes =
    "<path fill=\"#e00000\" d=\"M5 5h90v14h-90z\"/><path fill=\"#00a000\" d=\"M5 19h90v14h-90z\"/>"
    "<path fill=\"#0000e0\" d=\"M5 33h90v12h-90z\"/>";

TEST_F(CanvasFile, large_regions_lie_where_small_ones_do) {
  const std::vector<std::string> colours{"#e00000", "#00a000", "#0000e0"};
  const std::string file = svg(kStripes);
  const Canvas canvas = load_canvas({.width_px = 6000, .height_px = 3000, .file = file, .region_colours = colours});
  ASSERT_EQ(canvas.regions.size(), 3u);
  for (std::size_t k = 0; k < 3; ++k) {
    const CanvasField& field = canvas.regions[k].distance;
    const auto at = [&](float y) { return field.value(int(3000 - field.origin.x), int(y - field.origin.y)); };
    EXPECT_NEAR(at(60 * 12), k == 0 ? 420 : k == 1 ? -420 : -1260, 2) << k;
    EXPECT_NEAR(at(60 * 26), k == 0 ? -420 : k == 1 ? 420 : -420, 2) << k;
  }
}

/// In an image, too, no region counts as background, and enclosed areas belong to the nearest colour.
TEST_F(CanvasFile, regions_of_an_opaque_image_are_told_by_their_colours) {
  cv::Mat map(100, 200, CV_8UC3, cv::Scalar(0xe0, 0, 0));         // a sea up to all edges
  map(cv::Rect(50, 20, 100, 60)) = cv::Scalar(0xa0, 0xff, 0xf0);  // a pale island
  map(cv::Rect(90, 40, 20, 20)) = cv::Scalar(0xe0, 0, 0);         // with a lake
  const Canvas canvas =
      load_canvas({.width_px = 200, .height_px = 100, .file = png(map), .region_colours = {"#0000e0", "#f0ffa0"}});
  EXPECT_NEAR(canvas.area_px2, 200 * 100, 50);
  ASSERT_EQ(canvas.regions.size(), 2u);
  EXPECT_NEAR(canvas.regions[1].area_px2, 100 * 60 - 20 * 20, 50);
}

TEST_F(CanvasFile, all_regions_together_are_bounded) {
  CanvasSpec spec{.width_px = 12000, .height_px = 6000, .file = svg(kStripes)};
  for (int k = 0; k < 6; ++k) spec.region_colours.push_back("#e0000" + std::to_string(k));
  EXPECT_EQ(mistake(spec),
            "[[regions]]: found 6 on a canvas of 72.0 million px; allowed: 400 million px in all regions together");
}

class Grounds : public CanvasFile {
 protected:
  std::vector<Ground> grounds(std::vector<std::string> backgrounds) {
    const CanvasSpec spec{.width_px = 200,
                          .height_px = 100,
                          .file = svg(kStripes),
                          .region_colours = {"#e00000", "#00a000", "#0000e0"},
                          .region_backgrounds = std::move(backgrounds)};
    Drawers drawers(canvas_drawer_settings(spec));
    return canvas_edge(spec, drawers).grounds;
  }
};

TEST_F(Grounds, are_none_without_a_background) { EXPECT_TRUE(grounds({"", "", ""}).empty()); }

TEST_F(Grounds, end_where_the_next_one_begins) {
  const std::vector<Ground> stripes = grounds({"#102030", "", "#405060"});
  ASSERT_EQ(stripes.size(), 3u);
  EXPECT_EQ(stripes[0].colour, "#102030");
  EXPECT_EQ(stripes[1].colour, "");
  const float beneath_px = 8 * 200 / 4096.f;
  const double top[] = {0, 19 * 2, 33 * 2}, bottom[] = {19 * 2 + beneath_px, 33 * 2 + beneath_px, 100};
  for (std::size_t k = 0; k < 3; ++k) {
    ASSERT_EQ(stripes[k].curves.size(), 1u) << "specks of another region where two colours mix";
    double least = 1e9, most = -1e9;
    for (const Vec2 p : stripes[k].curves[0]) {
      EXPECT_TRUE(p.x <= 0.01f || p.x >= 199.99f || p.y <= 0.01 || p.y >= 99.99 ||
                  std::min(std::abs(p.y - top[k]), std::abs(p.y - bottom[k])) < 0.02)
          << k << ": " << p.x << " " << p.y;
      least = std::min(least, double(p.y)), most = std::max(most, double(p.y));
    }
    EXPECT_NEAR(std::max(least, 0.), top[k], 0.02) << k;
    EXPECT_NEAR(std::min(most, 100.), bottom[k], 0.02) << k;
  }
}

TEST_F(CanvasFile, a_seamless_rectangle_has_no_edge_at_its_seams) {
  for (const Seamless seamless : {Seamless::none, Seamless::x, Seamless::y, Seamless::both}) {
    const Canvas canvas = load_canvas({.width_px = 120, .height_px = 80, .file = "", .seamless = seamless});
    const bool in_x = seamless == Seamless::x || seamless == Seamless::both;
    const bool in_y = seamless == Seamless::y || seamless == Seamless::both;
    EXPECT_EQ(canvas.period, (Period{in_x ? 120 : 0, in_y ? 80 : 0}));
    EXPECT_EQ(distance_at(canvas, 1, 40) > 30, in_x);
    EXPECT_EQ(distance_at(canvas, 60, 79) > 30, in_y);
    EXPECT_EQ(canvas.area_px2, 120 * 80);
  }
}

TEST_F(CanvasFile, and_seamless_exclude_each_other) {
  const std::string file = svg("<circle r=\"20\" cx=\"25\" cy=\"25\"/>", "width=\"50\" height=\"50\"");
  EXPECT_EQ(mistake({.width_px = 100, .height_px = 100, .file = file, .seamless = Seamless::y}),
            "canvas.seamless: found \"y\" with the canvas.file " + file +
                ", allowed with a file: \"none\", as only a rectangle goes on across its edges");
}

KeepOutRectangle zone(Vec2 middle_px, Vec2 half_size_px) {
  return {.middle_px = middle_px, .half_size_px = half_size_px};
}

TEST_F(CanvasFile, what_the_keep_out_file_shows_is_taken_out) {
  CanvasSpec spec{.width_px = 200, .height_px = 160, .file = ""};
  spec.keep_out = svg("<rect x=\"20\" y=\"10\" width=\"40\" height=\"30\"/>");
  const Canvas canvas = load_canvas(spec);
  EXPECT_NEAR(canvas.area_px2, 200 * 160 - 80 * 60, 30);
  EXPECT_NEAR(distance_at(canvas, 80, 80), -30, 1) << "its page of 200 x 100 lies in the middle";
  EXPECT_NEAR(distance_at(canvas, 130, 80), 10, 1);
  EXPECT_NEAR(distance_at(canvas, 195, 80), 5, 1);
}

TEST_F(CanvasFile, zones_go_with_a_mask_its_regions_and_seams) {
  CanvasSpec spec{
      .width_px = 200, .height_px = 100, .file = svg("<rect width=\"100\" height=\"50\" fill=\"#00ff00\"/>")};
  spec.region_colours = {"#00ff00"};
  spec.keep_out_rectangles = {zone({100, 50}, {20, 20})};
  const Canvas regions = load_canvas(spec);
  ASSERT_EQ(regions.regions.size(), 1u);
  EXPECT_LT(regions.regions[0].distance.value(100, 50), -10);
  EXPECT_NEAR(regions.area_px2, 200 * 100 - 40 * 40, 30);
  CanvasSpec seamless{.width_px = 120, .height_px = 80, .file = "", .seamless = Seamless::both};
  seamless.keep_out_rectangles = {zone({0, 40}, {10, 10})};
  EXPECT_NEAR(distance_at(load_canvas(seamless), 115, 40), -5, 0.6);
  seamless.keep_out_rectangles.clear();
  seamless.keep_out = svg("<rect width=\"10\" height=\"50\"/>");
  EXPECT_NEAR(distance_at(load_canvas(seamless), 115, 40), 5, 1);
}

TEST_F(CanvasFile, zones_that_leave_or_show_nothing_are_mistakes) {
  CanvasSpec spec{.width_px = 200, .height_px = 100, .file = ""};
  spec.keep_out_rectangles = {zone({100, 50}, {200, 200})};
  EXPECT_EQ(mistake(spec), "canvas.keep_out and [[keep_out]] leave nothing of the canvas; needed: room for pieces");
  spec.keep_out_rectangles.clear();
  spec.keep_out = svg("");
  EXPECT_EQ(mistake(spec), "canvas.keep_out: " + spec.keep_out + " shows nothing; needed: an opaque silhouette on a " +
                               "transparent page or a plain background");
  spec.keep_out = folder_.path("none.svg");
  EXPECT_EQ(mistake(spec).find("canvas.keep_out: " + spec.keep_out), 0u) << mistake(spec);
  spec.keep_out = svg("<circle r=\"20\" cx=\"50\" cy=\"25\"/>");
  spec.width_px = 5000;
  EXPECT_EQ(mistake(spec), "canvas.keep_out: found " + spec.keep_out +
                               " with a canvas of 5000 x 100 px, allowed with a file: 4096 px or less each");
}

TEST(SeamlessCanvas, with_its_images_is_no_larger_than_a_canvas_may_be) {
  const PieceSettings pieces{.min_scale_px = 20, .max_scale_px = 160};
  EXPECT_NO_THROW(check_images(make_seamless_canvas(9000, 9000, true, true), pieces));
  EXPECT_THROW(check_images(make_seamless_canvas(9900, 9900, true, true), pieces), InputError);
  EXPECT_NO_THROW(check_images(make_rectangle_canvas(10000, 10000), pieces));
}

}  // namespace test_canvas_file
}  // namespace tessera
