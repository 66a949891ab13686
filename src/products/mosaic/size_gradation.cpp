#include "products/mosaic/size_gradation.h"

#include <algorithm>

namespace tessera {
namespace {

constexpr float kDiagonal = 7.f / 5;

/// Lowers a row by its neighbour, then along the row from `begin` in steps of `step`.
void take_from(const float* neighbour, float* row, int columns, float slope) {
  for (int x = 0; x < columns; ++x) {
    row[x] = std::min(row[x], neighbour[x] + slope);
    if (x > 0) row[x] = std::min(row[x], neighbour[x - 1] + kDiagonal * slope);
    if (x + 1 < columns) row[x] = std::min(row[x], neighbour[x + 1] + kDiagonal * slope);
  }
}

void sweep_along(float* row, int columns, float slope) {
  for (int x = 1; x < columns; ++x) row[x] = std::min(row[x], row[x - 1] + slope);
  for (int x = columns - 2; x >= 0; --x) row[x] = std::min(row[x], row[x + 1] + slope);
}

}  // namespace

void limit_growth(cv::Mat& sizes, float slope) {
  for (int y = 0; y < sizes.rows; ++y) {
    if (y > 0) take_from(sizes.ptr<float>(y - 1), sizes.ptr<float>(y), sizes.cols, slope);
    sweep_along(sizes.ptr<float>(y), sizes.cols, slope);
  }
  for (int y = sizes.rows - 2; y >= 0; --y) {
    take_from(sizes.ptr<float>(y + 1), sizes.ptr<float>(y), sizes.cols, slope);
    sweep_along(sizes.ptr<float>(y), sizes.cols, slope);
  }
}

}  // namespace tessera
