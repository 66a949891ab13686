#include "render/pieces/cairo_paint.h"

#include <algorithm>
#include <functional>

#include "artwork/images/cairo_objects.h"

namespace tessera {
namespace {

constexpr int kMostColumns = 16384;  // cairo's surfaces end at 32767

/// Calls `paint` for one part of the image after the other; it draws in px of the picture. The image's rows must be a
/// multiple of 4 bytes.
void paint_in_parts(cv::Mat& image, cv::Point corner, const std::function<void(cairo_t*)>& paint) {
  const cairo_format_t format = image.channels() == 1 ? CAIRO_FORMAT_A8 : CAIRO_FORMAT_ARGB32;
  for (int left = 0; left < image.cols; left += kMostColumns) {
    const int width = std::min(kMostColumns, image.cols - left);
    const CairoSurface surface(cairo_image_surface_create_for_data(image.ptr() + std::size_t(left) * image.elemSize(),
                                                                   format, width, image.rows, int(image.step)));
    const CairoContext cairo(cairo_create(surface.get()));
    cairo_translate(cairo.get(), -corner.x - left, -corner.y);
    cairo_set_antialias(cairo.get(), CAIRO_ANTIALIAS_BEST);
    paint(cairo.get());
    cairo_surface_flush(surface.get());
  }
}

void add_path(const PlacedCurves& placed, cairo_t* cairo) {
  for (const std::vector<Vec2>& curve : *placed.curves) {
    cairo_new_sub_path(cairo);
    for (const Vec2& point : curve) {
      const Vec2 p = placed.picture_from_curves.apply(point);
      cairo_line_to(cairo, double(p.x), double(p.y));
    }
    cairo_close_path(cairo);
  }
}

}  // namespace

cv::Mat filled_coverage(const Curves& curves, const Similarity& picture_from_curves, const cv::Rect& window) {
  return filled_coverage({PlacedCurves{&curves, picture_from_curves}}, window);
}

cv::Mat filled_coverage(const std::vector<PlacedCurves>& many, const cv::Rect& window) {
  cv::Mat padded(window.height, (window.width + 3) / 4 * 4, CV_8U, cv::Scalar(0));
  paint_in_parts(padded, window.tl(), [&](cairo_t* cairo) {
    cairo_set_fill_rule(cairo, CAIRO_FILL_RULE_EVEN_ODD);
    for (const PlacedCurves& placed : many) {
      add_path(placed, cairo);
      cairo_fill(cairo);
    }
  });
  return padded.colRange(0, window.width);
}

void draw_line(const PlacedCurves& curves, double width_px, const cv::Vec3b& bgr, cv::Point corner, cv::Mat bgra) {
  paint_in_parts(bgra, corner, [&](cairo_t* cairo) {
    cairo_set_source_rgb(cairo, bgr[2] / 255., bgr[1] / 255., bgr[0] / 255.);
    cairo_set_line_width(cairo, width_px);
    cairo_set_line_join(cairo, CAIRO_LINE_JOIN_ROUND);
    add_path(curves, cairo);
    cairo_stroke(cairo);
  });
}

}  // namespace tessera
