// golden_inputs FOLDER: writes the inputs of the golden jobs, made from formulas.
// - shapes.h5, the library
// - mask.png, a canvas with three holes at the resolution at which the program draws masks, so that nothing is scaled
// - picture.png and sizes.png, to be laid over a canvas
#include <cstdio>
#include <opencv2/imgproc.hpp>
#include <string>

#include "core/base/error.h"
#include "library/storage/library_file.h"
#include "support/images.h"
#include "support/matching_scene.h"

namespace {

constexpr int kShapes = 20;

void write_library(const std::string& path) {
  tessera::LibraryWriter writer(path, tessera::PadParameters{});
  int number = 0;
  for (tessera::Shape& shape : tessera::test::formula_shapes(kShapes, tessera::PadParameters{})) {
    shape.name = "shape " + std::to_string(number++);
    shape.artwork.width_px = shape.artwork.height_px = 100;
    const tessera::Lab mean = tessera::make_colour_model(shape.colour_grid, {0, 0}, {1, 1}).mean;
    shape.mean_lab = {mean.lightness, mean.a, mean.b};
    writer.append(shape);
  }
  writer.finish();
}

/// The mask of a canvas of 160 x 120 px.
void write_mask(const std::string& path) {
  cv::Mat mask(240, 320, CV_8UC4, cv::Scalar::all(0));
  const cv::Scalar inside(0, 0, 0, 255);
  const cv::Scalar outside = cv::Scalar::all(0);
  cv::rectangle(mask, {10, 10}, {309, 229}, inside, cv::FILLED);
  cv::rectangle(mask, {40, 40}, {89, 109}, outside, cv::FILLED);
  cv::rectangle(mask, {200, 60}, {229, 79}, outside, cv::FILLED);
  cv::circle(mask, {230, 160}, 30, outside, cv::FILLED);
  if (!tessera::test::write_image(path, mask)) throw tessera::EnvironmentError("cannot write " + path);
}

/// Patches of strong colours, one of them transparent.
void write_picture(const std::string& path) {
  cv::Mat picture(120, 160, CV_8UC4);
  for (int y = 0; y < picture.rows; ++y) {
    for (int x = 0; x < picture.cols; ++x) {
      const int patch = x / 40 + 4 * (y / 40);
      picture.at<cv::Vec4b>(y, x) = {std::uint8_t(patch * 70 % 256), std::uint8_t(patch * 110 % 256),
                                     std::uint8_t(255 - patch * 20), std::uint8_t(patch == 6 ? 0 : 255)};
    }
  }
  if (!tessera::test::write_image(path, picture)) throw tessera::EnvironmentError("cannot write " + path);
}

/// Sizes that grow from left to right.
void write_sizes(const std::string& path) {
  cv::Mat sizes(120, 160, CV_8U);
  for (int x = 0; x < sizes.cols; ++x) sizes.col(x) = 60 + x;
  if (!tessera::test::write_image(path, sizes)) throw tessera::EnvironmentError("cannot write " + path);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "golden_inputs FOLDER\n");
    return 2;
  }
  const std::string folder = argv[1];
  write_library(folder + "/shapes.h5");
  write_mask(folder + "/mask.png");
  write_picture(folder + "/picture.png");
  write_sizes(folder + "/sizes.png");
}
