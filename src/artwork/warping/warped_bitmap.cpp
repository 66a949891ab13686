#include "artwork/warping/warped_bitmap.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "artwork/images/alpha.h"
#include "artwork/svg/flattened_svg.h"
#include "artwork/svg/path_steps.h"
#include "artwork/warping/warped_picture.h"
#include "core/base/error.h"

namespace tessera {
namespace {

/// Longest side of a bitmap before the deformation, as of other embedded pictures; afterwards half of it.
constexpr double kMostSide_px = 2048;
/// Most nodes of a warp over a bitmap: one step for each pixel.
constexpr double kMostNodes = kMostSide_px * kMostSide_px;
/// Distance by which a bitmap continues beyond its edge: as far as the antialiased edge of a clip needs.
constexpr int kBorder_px = 2;

cv::Rect2d box_on_page(const PageBitmap& bitmap) {
  const cv::Rect2d own(0, 0, bitmap.bgra.cols, bitmap.bgra.rows);
  return box_of(transformed(bitmap.page_from_bitmap, rectangle_steps(own)));
}

PageBitmap with_border(const PageBitmap& bitmap) {
  PageBitmap larger = bitmap;
  cv::copyMakeBorder(bitmap.bgra, larger.bgra, kBorder_px, kBorder_px, kBorder_px, kBorder_px, cv::BORDER_REPLICATE);
  cairo_matrix_translate(&larger.page_from_bitmap, -kBorder_px, -kBorder_px);
  return larger;
}

/// Pixels of the bitmap for each unit of the page.
double density_of(const PageBitmap& bitmap) {
  const cairo_matrix_t& m = bitmap.page_from_bitmap;
  return 1 / std::sqrt(std::abs(m.xx * m.yy - m.xy * m.yx));
}

/// The bitmap with fewer pixels, each the mean of those that it replaces; premultiplied.
PageBitmap shrunk(const PageBitmap& bitmap, double factor) {
  if (factor >= 1) return bitmap;
  const cv::Size size(std::max(1, int(bitmap.bgra.cols * factor)), std::max(1, int(bitmap.bgra.rows * factor)));
  PageBitmap smaller = bitmap;
  cv::resize(bitmap.bgra, smaller.bgra, size, 0, 0, cv::INTER_AREA);
  cairo_matrix_scale(&smaller.page_from_bitmap, double(bitmap.bgra.cols) / size.width,
                     double(bitmap.bgra.rows) / size.height);
  return smaller;
}

/// The warp, continued beyond its own cells, on a grid that covers the box.
Warp covering(const Warp& warp, const cv::Rect2d& box) {
  const cv::Rect2d own(warp.origin.x, warp.origin.y, double(warp.step) * warp.displacement.width(),
                       double(warp.step) * warp.displacement.height());
  const cv::Rect2d both = box | own;
  const double columns = both.width / warp.step + 2, rows = both.height / warp.step + 2;
  if (!(columns * rows <= kMostNodes)) throw InputError("a warp that is too fine for a bitmap");
  return spread(warp, {float(box.x), float(box.y)}, {float(box.x + box.width), float(box.y + box.height)});
}

/// A box round the image of `box`, which the warp's grid covers.
cv::Rect2d around_image(const cv::Rect2d& box, const Warp& warp) {
  Vec2 low = warp.displacement(0, 0), high = low;
  for (const Vec2 d : warp.displacement.data()) {
    low = {std::min(low.x, d.x), std::min(low.y, d.y)};
    high = {std::max(high.x, d.x), std::max(high.y, d.y)};
  }
  return {box.tl() + cv::Point2d(low.x, low.y), box.br() + cv::Point2d(high.x, high.y)};
}

/// The entries of an affine map.
cv::Matx23d entries(const cairo_matrix_t& m) { return {m.xx, m.xy, m.x0, m.yx, m.yy, m.y0}; }

/// The smallest window with all pixels that are not clear.
cv::Rect window_of_ink(const cv::Mat& bgra) {
  cv::Mat alpha;
  cv::extractChannel(bgra, alpha, 3);
  return cv::boundingRect(alpha);
}

}  // namespace

WarpedBitmap warped_bitmap(const PageBitmap& bitmap, const Warp& page_warp, cv::Size2d page, bool goes_on) {
  PageBitmap source{premultiplied(bitmap.bgra), bitmap.page_from_bitmap};
  if (goes_on) source = with_border(source);
  const cv::Rect2d box = box_on_page(source) & cv::Rect2d({0, 0}, page);
  const double density = density_of(source);
  if (box.empty() || !std::isfinite(density)) return {};
  const double finest = kMostSide_px / std::max(box.width, box.height);
  const double scale = std::min(finest, std::max(density, kFlattenedSide / std::max(page.width, page.height)));
  source = shrunk(source, scale / density);

  const Warp cover = covering(page_warp, box);
  const cv::Rect2d image = around_image(box, cover);
  if (!(std::max(image.width, image.height) * scale <= 2 * kMostSide_px)) {
    throw InputError("a warp that tears a bitmap too far apart");
  }
  const cv::Size size(int(std::ceil(image.width * scale)), int(std::ceil(image.height * scale)));

  // Maps page px (pixels of the result without displacement) to the bitmap.
  const cv::Point2d corner_px = image.tl() * scale;
  cairo_matrix_t bitmap_from_px = source.page_from_bitmap;
  if (cairo_matrix_invert(&bitmap_from_px) != CAIRO_STATUS_SUCCESS) return {};
  cairo_matrix_scale(&bitmap_from_px, 1 / scale, 1 / scale);
  cairo_matrix_translate(&bitmap_from_px, corner_px.x, corner_px.y);
  const Warp px_warp = in_frame(cover, float(scale), {-float(corner_px.x), -float(corner_px.y)}, false);
  const cv::Mat drawn = warped_picture(source.bgra, entries(bitmap_from_px), px_warp, size);
  const cv::Rect ink = window_of_ink(drawn);
  if (ink.empty()) return {};
  return {straightened(drawn(ink)), cv::Rect2d((ink.x + corner_px.x) / scale, (ink.y + corner_px.y) / scale,
                                               ink.width / scale, ink.height / scale)};
}

}  // namespace tessera
