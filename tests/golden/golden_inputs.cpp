// golden_inputs FOLDER: writes what the golden jobs read, made from formulas: the library shapes.h5, and mask.png, a
// canvas with three holes at the resolution that the program draws masks at, so that nothing is scaled.
#include <cstdio>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <string>

#include "core/base/error.h"
#include "io/library/library_file.h"
#include "support/matching_scene.h"

namespace {

constexpr int kShapes = 20;

void write_library(const std::string& path) {
  tessera::io::LibraryWriter writer(path, tessera::PadParameters{});
  int number = 0;
  for (tessera::Shape& shape : tessera::test::formula_shapes(kShapes, tessera::PadParameters{})) {
    shape.name = "shape " + std::to_string(number++);
    shape.artwork.width_px = shape.artwork.height_px = 100;
    writer.append(shape);
  }
  writer.finish();
}

/// For a canvas of 160 x 120 px.
void write_mask(const std::string& path) {
  cv::Mat mask(240, 320, CV_8UC4, cv::Scalar::all(0));
  const cv::Scalar inside(0, 0, 0, 255);
  const cv::Scalar outside = cv::Scalar::all(0);
  cv::rectangle(mask, {10, 10}, {309, 229}, inside, cv::FILLED);
  cv::rectangle(mask, {40, 40}, {89, 109}, outside, cv::FILLED);
  cv::rectangle(mask, {200, 60}, {229, 79}, outside, cv::FILLED);
  cv::circle(mask, {230, 160}, 30, outside, cv::FILLED);
  if (!cv::imwrite(path, mask)) throw tessera::EnvironmentError("cannot write " + path);
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
}
