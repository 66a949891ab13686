#include "io/job/canvas_regions.h"

#include <cstdint>

#include "core/base/error.h"

namespace tessera::io {
namespace {

/// Of "#rrggbb", as OpenCV has it.
cv::Vec3i bgr_of(const std::string& colour) {
  const int rgb = std::stoi(colour.substr(1), nullptr, 16);
  return {rgb & 255, rgb >> 8 & 255, rgb >> 16};
}

std::size_t nearest_colour(const cv::Vec4b& pixel, const std::vector<cv::Vec3i>& colours) {
  std::size_t nearest = 0;
  int least = INT32_MAX;
  for (std::size_t k = 0; k < colours.size(); ++k) {
    int squares = 0;
    for (int c = 0; c < 3; ++c) squares += (pixel[c] - colours[k][c]) * (pixel[c] - colours[k][c]);
    if (squares >= least) continue;
    least = squares;
    nearest = k;
  }
  return nearest;
}

}  // namespace

std::vector<CanvasField> region_distances(const cv::Mat& page, const Grid<float>& coverage, const CanvasSpec& spec) {
  std::vector<cv::Vec3i> colours;
  for (const std::string& colour : spec.region_colours) colours.push_back(bgr_of(colour));
  std::vector<CanvasField> distances;
  for (std::size_t k = 0; k < colours.size(); ++k) {
    Grid<float> own(coverage.width(), coverage.height(), 0.f);
    for (int y = 0; y < page.rows; ++y) {
      for (int x = 0; x < page.cols; ++x) {
        if (nearest_colour(page.at<cv::Vec4b>(y, x), colours) == k) own(x, y) = coverage(x, y);
      }
    }
    Canvas region = make_mask_canvas(own);
    if (region.area_px2 <= 0) {
      throw InputError("canvas file " + spec.file + ": no place of it is nearest to " + spec.region_colours[k] +
                       ", the colour of one of [[regions]]");
    }
    distances.push_back(std::move(region.distance));
  }
  return distances;
}

}  // namespace tessera::io
