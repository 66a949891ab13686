#include "artwork/warping/warped_picture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace tessera {
namespace {

/// A pixel's centre this far beyond a triangle still counts as inside, so that none falls between two. It is far more
/// than rounding moves an edge, and far less than an eye sees.
constexpr double kTolerance_px = 1e-3;

/// The source is sampled at multiples of 1 / 256 px: exact for whole px, and half a grey level between black and white.
constexpr int kSubpixelBits = 8;
constexpr int kSubpixels = 1 << kSubpixelBits;

/// The nodes of a triangle in the source and in the result.
struct Triangle {
  std::array<cv::Point2d, 3> source;
  std::array<cv::Point2d, 3> result;
};

/// Twice the triangle's area, with sign.
double doubled_area(cv::Point2d a, cv::Point2d b, cv::Point2d c) { return (b - a).cross(c - a); }

/// The affine map from the result to the source: its value at (0, 0), and its change for each px right and down.
struct Lookup {
  cv::Point2d origin, right, down;

  cv::Point2d at(cv::Point2d p) const { return origin + right * p.x + down * p.y; }
};

Lookup lookup_of(const Triangle& t, double area) {
  const cv::Point2d p = t.result[1] - t.result[0], q = t.result[2] - t.result[0];
  const cv::Point2d u = t.source[1] - t.source[0], v = t.source[2] - t.source[0];
  Lookup lookup{.origin = {}, .right = (u * q.y - v * p.y) / area, .down = (v * p.x - u * q.x) / area};
  lookup.origin = t.source[0] - lookup.right * t.result[0].x - lookup.down * t.result[0].y;
  return lookup;
}

/// The x range of a triangle in a row; begin > end where it does not reach the row.
struct Span {
  double begin, end;
};

/// Cuts the span to the inner side of the edge from a to b, with the tolerance.
void cut(Span& span, cv::Point2d a, cv::Point2d b, double y, double side) {
  const cv::Point2d along = (b - a) * side;
  const double length = std::sqrt(along.dot(along));
  // along.x (y - a.y) - along.y (x - a.x) >= -tolerance * length
  const double rest = along.x * (y - a.y) + along.y * a.x + kTolerance_px * length;
  if (along.y > 0) span.end = std::min(span.end, rest / along.y);
  if (along.y < 0) span.begin = std::max(span.begin, rest / along.y);
  if (along.y == 0 && rest < 0) span.end = span.begin - 1;
}

Span row_of(const Triangle& t, double y, double side) {
  const auto [left, right] = std::minmax({t.result[0].x, t.result[1].x, t.result[2].x});
  Span span{left - kTolerance_px, right + kTolerance_px};
  for (int k = 0; k < 3; ++k) cut(span, t.result[std::size_t(k)], t.result[std::size_t((k + 1) % 3)], y, side);
  return span;
}

/// The first pixel whose centre is at x or beyond, from 0 to count.
int first_pixel(double x, int count) { return int(std::clamp(std::ceil(x - 0.5), 0., double(count))); }

/// A place in a picture, in sub-pixels from the centre of the first pixel.
struct Place {
  int u, v;
};

/// Interpolates bilinearly between two pixels one below the other and their two right neighbours.
cv::Vec4b between(const std::uint8_t* upper, const std::uint8_t* lower, Place place) {
  const int s = place.u & (kSubpixels - 1), t = place.v & (kSubpixels - 1);
  const int weights[4] = {(kSubpixels - s) * (kSubpixels - t), s * (kSubpixels - t), (kSubpixels - s) * t, s * t};
  cv::Vec4b colour;
  for (int c = 0; c < 4; ++c) {
    const int sum =
        upper[c] * weights[0] + upper[c + 4] * weights[1] + lower[c] * weights[2] + lower[c + 4] * weights[3];
    colour[c] = std::uint8_t((sum + (1 << (2 * kSubpixelBits - 1))) >> (2 * kSubpixelBits));
  }
  return colour;
}

class Sampler {
 public:
  explicit Sampler(const cv::Mat& bgra) : bgra_(bgra) {}

  /// The picture at p, in continuous px.
  cv::Vec4b at(cv::Point2d p) const {
    const Place place{subpixels(p.x, bgra_.cols), subpixels(p.y, bgra_.rows)};
    const int x = place.u >> kSubpixelBits, y = place.v >> kSubpixelBits;
    if (x >= 0 && y >= 0 && x + 1 < bgra_.cols && y + 1 < bgra_.rows) return inside(place);
    std::uint8_t pixels[16];
    copy_pixels(x, y, pixels);
    return between(pixels, pixels + 8, place);
  }

  /// The picture at p, which must have pixels on all sides.
  cv::Vec4b at_inner(cv::Point2d p) const {
    return inside({int((p.x - 0.5) * kSubpixels + 0.5), int((p.y - 0.5) * kSubpixels + 0.5)});
  }
  bool is_inner(cv::Point2d p) const { return p.x >= 1 && p.y >= 1 && p.x <= bgra_.cols - 1 && p.y <= bgra_.rows - 1; }

 private:
  static int subpixels(double x, int count) {
    return int(std::floor(std::clamp(x - 0.5, -1., double(count)) * kSubpixels + 0.5));
  }

  cv::Vec4b inside(Place place) const {
    const std::uint8_t* upper =
        bgra_.data + std::size_t(place.v >> kSubpixelBits) * bgra_.step[0] + 4 * std::size_t(place.u >> kSubpixelBits);
    return between(upper, upper + bgra_.step[0], place);
  }

  /// The four pixels from (x, y) on, where some lie outside the picture: these are clear.
  void copy_pixels(int x, int y, std::uint8_t* to) const {
    for (int k = 0; k < 4; ++k, to += 4) {
      const int i = x + k % 2, j = y + k / 2;
      const bool is_there = i >= 0 && j >= 0 && i < bgra_.cols && j < bgra_.rows;
      for (int c = 0; c < 4; ++c) to[c] = is_there ? bgra_.ptr(j)[4 * i + c] : 0;
    }
  }

  const cv::Mat& bgra_;
};

/// Fills pixels begin to end (not empty) of the row whose centres are at y.
void fill_row(cv::Vec4b* row, int begin, int end, const Lookup& lookup, double y, const Sampler& sampler) {
  const auto source = [&](int x) { return lookup.at({x + 0.5, y}); };
  if (sampler.is_inner(source(begin)) && sampler.is_inner(source(end - 1))) {  // and so is all between
    for (int x = begin; x < end; ++x) row[x] = sampler.at_inner(source(x));
  } else {
    for (int x = begin; x < end; ++x) row[x] = sampler.at(source(x));
  }
}

void fill(const Triangle& triangle, const Sampler& sampler, cv::Mat& result) {
  const double area = doubled_area(triangle.result[0], triangle.result[1], triangle.result[2]);
  if (area == 0 || !std::isfinite(area)) return;
  const Lookup lookup = lookup_of(triangle, area);
  const auto [top, bottom] = std::minmax({triangle.result[0].y, triangle.result[1].y, triangle.result[2].y});
  const int end = first_pixel(bottom + kTolerance_px, result.rows);
  for (int y = first_pixel(top - kTolerance_px, result.rows); y < end; ++y) {
    const Span span = row_of(triangle, y + 0.5, area > 0 ? 1 : -1);
    if (span.begin > span.end) continue;
    auto* row = result.ptr<cv::Vec4b>(y);
    const int begin = first_pixel(span.begin, result.cols), row_end = first_pixel(span.end, result.cols);
    if (begin < row_end) fill_row(row, begin, row_end, lookup, y + 0.5, sampler);
  }
}

class WarpedNodes {
 public:
  WarpedNodes(const Warp& warp, const cv::Matx23d& source_from_page) : warp_(warp), map_(source_from_page) {}

  Triangle triangle(int i0, int j0, int i1, int j1, int i2, int j2) const {
    return {{source(i0, j0), source(i1, j1), source(i2, j2)}, {result(i0, j0), result(i1, j1), result(i2, j2)}};
  }

 private:
  cv::Point2d source(int i, int j) const {
    const Vec2 p = warp_.node(i, j);
    return {map_(0, 0) * p.x + map_(0, 1) * p.y + map_(0, 2), map_(1, 0) * p.x + map_(1, 1) * p.y + map_(1, 2)};
  }
  cv::Point2d result(int i, int j) const {
    const Vec2 p = warp_.warped_node(i, j);
    return {p.x, p.y};
  }

  const Warp& warp_;
  const cv::Matx23d& map_;
};

}  // namespace

cv::Mat warped_picture(const cv::Mat& bgra, const cv::Matx23d& source_from_page, const Warp& page_warp, cv::Size size) {
  CV_Assert(bgra.type() == CV_8UC4 && !bgra.empty());
  cv::Mat result(size, CV_8UC4, cv::Scalar::all(0));
  const Sampler sampler(bgra);
  const WarpedNodes nodes(page_warp, source_from_page);
  for (int j = 0; j < page_warp.active.height(); ++j) {
    for (int i = 0; i < page_warp.active.width(); ++i) {
      if (!page_warp.active(i, j)) continue;
      const bool falling = page_warp.falling;
      fill(nodes.triangle(i, j, i + 1, j, falling ? i + 1 : i, j + 1), sampler, result);
      fill(nodes.triangle(falling ? i : i + 1, j, i + 1, j + 1, i, j + 1), sampler, result);
    }
  }
  return result;
}

cv::Mat warped_picture(const cv::Mat& bgra, const Warp& pixel_warp, cv::Size size) {
  return warped_picture(bgra, cv::Matx23d(1, 0, 0, 0, 1, 0), pixel_warp, size);
}

}  // namespace tessera
