#include "job/canvas/canvas_regions.h"

#include <cstdint>
#include <opencv2/imgproc.hpp>

#include "artwork/images/colour_conversion.h"
#include "artwork/images/mask.h"
#include "core/base/error.h"
#include "job/job_keys.h"
#include "text/number_text.h"

namespace tessera {
namespace {

/// A background whose distance from a region's colour (all three channels together) is at most this is that region.
constexpr int kSameColour = 48;

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

/// The regions' colours, followed by the colour of the background, if there is one.
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

/// Coverage of the pixels whose label `counts`.
template <class Counts>
Grid<float> coverage_where(const cv::Mat& page, const cv::Mat_<short>& labels, Counts counts) {
  Grid<float> coverage(page.cols, page.rows, 0.f);
  for (int y = 0; y < page.rows; ++y) {
    for (int x = 0; x < page.cols; ++x) {
      if (counts(labels(y, x))) coverage(x, y) = float(page.at<cv::Vec4b>(y, x)[3]) / 255;
    }
  }
  return coverage;
}

/// Throws InputError where the regions' fields, each as large as the canvas, would take too much memory.
void check_memory(const CanvasPage& page, std::size_t regions) {
  constexpr double kMostFields_px2 = 4 * kMaxCanvas_px2;
  const double canvas_px2 = double(page.width_px) * page.height_px;
  if (double(regions) * canvas_px2 <= kMostFields_px2) return;
  throw InputError("[[regions]]: found " + std::to_string(regions) + " on a canvas of " + fixed(canvas_px2 / 1e6, 1) +
                   " million px; allowed: " + fixed(kMostFields_px2 / 1e6, 0) + " million px in all regions together");
}

}  // namespace

cv::Mat_<short> region_labels(const cv::Mat& page, const CanvasSpec& spec) {
  const std::vector<cv::Vec3i> colours = colours_of(page, spec);
  cv::Mat_<short> labels(page.size());
  for (int y = 0; y < page.rows; ++y) {
    for (int x = 0; x < page.cols; ++x) {
      const std::size_t nearest = nearest_colour(page.at<cv::Vec4b>(y, x), colours);
      labels(y, x) = short(nearest < spec.region_colours.size() ? int(nearest) : kNoRegion);
    }
  }
  return labels;
}

Grid<float> region_coverage(const cv::Mat& page, const cv::Mat_<short>& labels) {
  return coverage_where(page, labels, [](int label) { return label != kNoRegion; });
}

std::vector<CanvasRegion> canvas_regions(const CanvasPage& page, const cv::Mat_<short>& labels,
                                         const CanvasSpec& spec) {
  check_memory(page, spec.region_colours.size());
  std::vector<CanvasRegion> regions;
  for (std::size_t region = 0; region < spec.region_colours.size(); ++region) {
    const Grid<float> coverage = coverage_where(page.bgra, labels, [&](int label) { return label == int(region); });
    Canvas part = make_mask_canvas(coverage_on_canvas(page, coverage), page.cells_per_px);
    if (part.area_px2 <= 0) {
      throw InputError("canvas file " + spec.file + ": none of its pixels is nearest to " +
                       spec.region_colours[region] + ", the colour of one of [[regions]]");
    }
    regions.push_back({std::move(part.distance), part.area_px2});
  }
  return regions;
}

}  // namespace tessera
