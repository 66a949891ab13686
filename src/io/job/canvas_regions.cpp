#include "io/job/canvas_regions.h"

#include <cstdint>
#include <opencv2/imgproc.hpp>

#include "core/base/error.h"
#include "io/artwork/mask.h"

namespace tessera::io {
namespace {

/// A background that is no further from a region's colour, in all three channels together, is that region.
constexpr int kSameColour = 48;

/// Of "#rrggbb", as OpenCV has it.
cv::Vec3i bgr_of(const std::string& colour) {
  const int rgb = std::stoi(colour.substr(1), nullptr, 16);
  return {rgb & 255, rgb >> 8 & 255, rgb >> 16};
}

int squared_difference(const cv::Vec3i& a, const cv::Vec3i& b) { return (a - b).dot(a - b); }

std::size_t nearest_colour(const cv::Vec4b& pixel, const std::vector<cv::Vec3i>& colours) {
  std::size_t nearest = 0;
  int least = INT32_MAX;
  for (std::size_t k = 0; k < colours.size(); ++k) {
    const int squares = squared_difference({pixel[0], pixel[1], pixel[2]}, colours[k]);
    if (squares >= least) continue;
    least = squares;
    nearest = k;
  }
  return nearest;
}

bool is_opaque(const cv::Mat& page) {
  cv::Mat alpha;
  cv::extractChannel(page, alpha, 3);
  double least = 255;
  cv::minMaxLoc(alpha, &least);
  return least >= 128;
}

/// The regions' colours, and behind them that of a background where there is one.
std::vector<cv::Vec3i> colours_of(const cv::Mat& page, const CanvasSpec& spec) {
  std::vector<cv::Vec3i> colours;
  for (const std::string& colour : spec.region_colours) colours.push_back(bgr_of(colour));
  if (!is_opaque(page)) return colours;
  cv::Mat bgr;
  cv::cvtColor(page, bgr, cv::COLOR_BGRA2BGR);
  const cv::Vec3i background = prevailing_edge_colour(bgr);
  for (const cv::Vec3i& colour : colours) {
    if (squared_difference(colour, background) <= kSameColour * kSameColour) return colours;
  }
  colours.push_back(background);
  return colours;
}

/// Of the places whose nearest colour `counts`.
template <class Counts>
Grid<float> coverage_where(const cv::Mat& page, const std::vector<cv::Vec3i>& colours, Counts counts) {
  Grid<float> coverage(page.cols + page.cols % 2, page.rows + page.rows % 2, 0.f);
  for (int y = 0; y < page.rows; ++y) {
    for (int x = 0; x < page.cols; ++x) {
      const cv::Vec4b& pixel = page.at<cv::Vec4b>(y, x);
      if (counts(nearest_colour(pixel, colours))) coverage(x, y) = float(pixel[3]) / 255;
    }
  }
  return coverage;
}

}  // namespace

Grid<float> region_coverage(const cv::Mat& page, const CanvasSpec& spec) {
  return coverage_where(page, colours_of(page, spec), [&](std::size_t k) { return k < spec.region_colours.size(); });
}

std::vector<CanvasRegion> canvas_regions(const cv::Mat& page, const CanvasSpec& spec) {
  const std::vector<cv::Vec3i> colours = colours_of(page, spec);
  std::vector<CanvasRegion> regions;
  for (std::size_t region = 0; region < spec.region_colours.size(); ++region) {
    Canvas part = make_mask_canvas(coverage_where(page, colours, [&](std::size_t k) { return k == region; }));
    if (part.area_px2 <= 0) {
      throw InputError("canvas file " + spec.file + ": no place of it is nearest to " + spec.region_colours[region] +
                       ", the colour of one of [[regions]]");
    }
    regions.push_back({std::move(part.distance), part.area_px2});
  }
  return regions;
}

}  // namespace tessera::io
