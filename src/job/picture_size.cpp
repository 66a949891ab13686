#include "job/picture_size.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>

#include "core/base/error.h"
#include "job/job_keys.h"
#include "job/millimetres.h"
#include "text/number_text.h"

namespace tessera {
namespace {

std::string found(const OutputSpec& output) {
  if (output.width_mm == 0) return "output.width_px: found " + std::to_string(output.width_px);
  return "output.width_mm: found " + fixed(output.width_mm, 3) + " at an output.dpi of " + fixed(output.dpi, 3);
}

/// The value of the key that gives this width in px, as text.
std::string allowed(const OutputSpec& output, int width_px) {
  return output.width_mm == 0 ? std::to_string(width_px)
                              : fixed(std::floor(width_px * kMmPerInch / output.dpi * 10) / 10, 1) + " mm";
}

/// The canvas' size on paper in mm; 0 x 0 where it has none. A canvas with a file may be smaller than the job's box.
cv::Size2d canvas_size_mm(const CanvasSpec& spec, const Canvas& canvas) {
  if (spec.width_mm == 0) return {};
  const auto side = [&](int px, int box_px, double box_mm) { return px == box_px ? box_mm : px / px_per_mm(spec); };
  return {side(canvas.width_px, spec.width_px, spec.width_mm), side(canvas.height_px, spec.height_px, spec.height_mm)};
}

/// Checks that the height is a whole number of px: otherwise copies one below the other would not meet.
void check_whole_height(const OutputSpec& output, int width_px, const Canvas& canvas) {
  const long long rows = (long long)(width_px)*canvas.height_px;
  if (canvas.period.y_px == 0 || rows % canvas.width_px == 0) return;
  const int step = canvas.width_px / std::gcd(canvas.width_px, canvas.height_px);
  throw InputError(
      found(output) + ", which makes collage.png " + fixed(double(rows) / canvas.width_px, 2) +
      " px high; allowed for a canvas that is seamless from top to bottom: a width that is a multiple of " +
      std::to_string(step) + " px");
}

}  // namespace

OutputSpec on_paper(OutputSpec output, const CanvasSpec& spec, const Canvas& canvas) {
  if (output.width_mm == 0) output.width_mm = canvas_size_mm(spec, canvas).width;
  return output;
}

cv::Size2d page_size_mm(const OutputSpec& output, const CanvasSpec& spec, const Canvas& canvas) {
  const cv::Size2d size =
      spec.width_mm > 0 ? canvas_size_mm(spec, canvas) : cv::Size2d(canvas.width_px, canvas.height_px);
  return {output.width_mm, size.height * (output.width_mm / size.width)};
}

cv::Size2d page_size_px(const CanvasSpec& spec, const Canvas& canvas) {
  const bool repeats = canvas.period.x_px > 0 || canvas.period.y_px > 0;
  if (spec.width_mm == 0 || repeats) return cv::Size2d(canvas.width_px, canvas.height_px);
  return canvas_size_mm(spec, canvas) * px_per_mm(spec);
}

int picture_width_px(const OutputSpec& output) {
  return output.width_mm == 0 ? output.width_px : int(std::lround(output.width_mm / kMmPerInch * output.dpi));
}

cv::Size picture_size_px(const OutputSpec& output, const Canvas& canvas) {
  const int width_px = picture_width_px(output);
  const double px = double(width_px) / canvas.width_px;
  return {width_px, std::max(1, cvRound(canvas.height_px * px))};
}

void check_picture_size(const OutputSpec& output, const Canvas& canvas) {
  const JobKey& key = *find_job_key("output", "width_px");
  const cv::Size size = picture_size_px(output, canvas);
  if (size.width < int(key.min)) {
    throw InputError(found(output) + ", which makes collage.png " + std::to_string(size.width) +
                     " px wide; allowed: " + std::to_string(int(key.min)) + " px or more");
  }
  check_whole_height(output, size.width, canvas);
  const double aspect = double(canvas.width_px) / canvas.height_px;
  if (size.width <= int(key.max) && size.height <= int(key.max)) return;
  throw InputError(
      found(output) + ", which makes collage.png " + std::to_string(size.width) + " x " + std::to_string(size.height) +
      " px large; allowed for this canvas: " + allowed(output, int(key.max * std::min(1., aspect))) + " or less");
}

}  // namespace tessera
