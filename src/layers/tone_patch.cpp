#include "layers/tone_patch.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "layers/affine.h"

namespace tessera {
namespace {

/// Cells that are added on each side: deformed pieces reach beyond the grid, where a smoothed picture would fade.
constexpr int kRing = 2;

/// The colour premultiplied, with alpha from 0 to 1.
cv::Vec4f premultiplied(const cv::Vec4b& bgra) {
  const float alpha = float(bgra[3]) / 255;
  return {float(bgra[0]) * alpha, float(bgra[1]) * alpha, float(bgra[2]) * alpha, alpha};
}

using Cells = std::array<cv::Vec4f, kColourCells>;

/// The colour at a point of the grid; a cell is one unit.
cv::Vec4f at(const Cells& cells, double x, double y) {
  const double u = std::clamp(x - 0.5, 0., kColourSide - 1.);
  const double v = std::clamp(y - 0.5, 0., kColourSide - 1.);
  const int column = std::min(int(u), kColourSide - 2);
  const int row = std::min(int(v), kColourSide - 2);
  const float s = float(u - column), t = float(v - row);
  const cv::Vec4f* upper = cells.data() + row * kColourSide + column;
  const cv::Vec4f* lower = upper + kColourSide;
  const cv::Vec4f above = upper[0] + (upper[1] - upper[0]) * s;
  const cv::Vec4f below = lower[0] + (lower[1] - lower[0]) * s;
  return above + (below - above) * t;
}

void lay_over_pixel(const cv::Vec4f& patch, cv::Vec4b& pixel) {
  const float shown = 1 - patch[3];
  const float alpha = float(pixel[3]) / 255;
  for (int c = 0; c < 3; ++c) {
    const float mixed = float(pixel[c]) * shown + patch[c] * alpha;
    pixel[c] = std::uint8_t(std::min(int(mixed + 0.5f), int(pixel[3])));
  }
}

}  // namespace

bool TonePatch::empty() const {
  return std::all_of(bgra.begin(), bgra.end(), [](const cv::Vec4b& cell) { return cell[3] == 0; });
}

cv::Vec4d TonePatch::mean() const {
  cv::Vec4d sum;
  for (const cv::Vec4b& cell : bgra) sum += cv::Vec4d(premultiplied(cell));
  return sum / double(kColourCells);
}

cv::Mat patch_picture(const TonePatch& patch) {
  cv::Mat picture(kColourSide + 2 * kRing, kColourSide + 2 * kRing, CV_8UC4);
  for (int y = 0; y < picture.rows; ++y) {
    for (int x = 0; x < picture.cols; ++x) {
      const int row = std::clamp(y - kRing, 0, kColourSide - 1), column = std::clamp(x - kRing, 0, kColourSide - 1);
      picture.at<cv::Vec4b>(y, x) = patch.bgra[std::size_t(row * kColourSide + column)];
    }
  }
  return picture;
}

cv::Matx23d canvas_from_patch_picture(const TonePatch& patch) {
  return joined(patch.canvas_from_cells, {1, 0, -kRing, 0, 1, -kRing});
}

void lay_patch(const TonePatch& patch, cv::Point origin, double picture_px, cv::Mat& bgra) {
  if (patch.empty()) return;
  Cells cells;
  std::transform(patch.bgra.begin(), patch.bgra.end(), cells.begin(),
                 [](const cv::Vec4b& cell) { return premultiplied(cell); });
  const cv::Matx23d m = inverse(patch.canvas_from_cells);
  for (int y = 0; y < bgra.rows; ++y) {
    cv::Vec4b* row = bgra.ptr<cv::Vec4b>(y);
    const double canvas_y = (origin.y + y + 0.5) / picture_px;
    for (int x = 0; x < bgra.cols; ++x) {
      if (row[x][3] == 0) continue;
      const double canvas_x = (origin.x + x + 0.5) / picture_px;
      lay_over_pixel(at(cells, m(0, 0) * canvas_x + m(0, 1) * canvas_y + m(0, 2),
                        m(1, 0) * canvas_x + m(1, 1) * canvas_y + m(1, 2)),
                     row[x]);
    }
  }
}

}  // namespace tessera
