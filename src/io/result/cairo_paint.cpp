#include "io/result/cairo_paint.h"

#include <algorithm>
#include <functional>

#include "io/cairo_objects.h"

namespace tessera::io {
namespace {

constexpr int kMostColumns = 16384;  // cairo's surfaces end at 32767

/// `paint` draws in px of the picture, into one part of the image after the other. Its rows are a multiple of 4 bytes.
void paint_in_parts(cv::Mat& image, cv::Point corner, const std::function<void(cairo_t*)>& paint) {
  const cairo_format_t format = image.channels() == 1 ? CAIRO_FORMAT_A8 : CAIRO_FORMAT_ARGB32;
  for (int left = 0; left < image.cols; left += kMostColumns) {
    const int width = std::min(kMostColumns, image.cols - left);
    const CairoSurface surface(cairo_image_surface_create_for_data(
        image.ptr() + std::size_t(left) * image.elemSize(), format, width, image.rows, int(image.step)));
    const CairoContext cairo(cairo_create(surface.get()));
    cairo_translate(cairo.get(), -corner.x - left, -corner.y);
    cairo_set_antialias(cairo.get(), CAIRO_ANTIALIAS_BEST);
    paint(cairo.get());
    cairo_surface_flush(surface.get());
  }
}

void add_path(const Curves& curves, const Similarity& picture_from_curves, cairo_t* cairo) {
  for (const std::vector<Vec2>& curve : curves) {
    cairo_new_sub_path(cairo);
    for (const Vec2& point : curve) {
      const Vec2 p = picture_from_curves.apply(point);
      cairo_line_to(cairo, double(p.x), double(p.y));
    }
    cairo_close_path(cairo);
  }
}

}  // namespace

cv::Mat filled_coverage(const Curves& curves, const Similarity& picture_from_curves, const cv::Rect& window) {
  cv::Mat padded(window.height, (window.width + 3) / 4 * 4, CV_8U, cv::Scalar(0));
  paint_in_parts(padded, window.tl(), [&](cairo_t* cairo) {
    cairo_set_fill_rule(cairo, CAIRO_FILL_RULE_EVEN_ODD);
    add_path(curves, picture_from_curves, cairo);
    cairo_fill(cairo);
  });
  return padded.colRange(0, window.width);
}

}  // namespace tessera::io
