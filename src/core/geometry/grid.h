// A dense two-dimensional array, row by row, and integer windows into it.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace tessera {

/// Half-open range of grid nodes [x0, x1) x [y0, y1).
struct Window {
  int x0 = 0;
  int y0 = 0;
  int x1 = 0;
  int y1 = 0;

  int width() const { return x1 - x0; }
  int height() const { return y1 - y0; }
  bool empty() const { return x0 >= x1 || y0 >= y1; }
  bool contains(int x, int y) const { return x >= x0 && x < x1 && y >= y0 && y < y1; }
  bool overlaps(const Window& o) const { return x0 < o.x1 && o.x0 < x1 && y0 < o.y1 && o.y0 < y1; }
  Window grown(int by) const { return {x0 - by, y0 - by, x1 + by, y1 + by}; }
  Window intersected(const Window& o) const {
    return {std::max(x0, o.x0), std::max(y0, o.y0), std::min(x1, o.x1), std::min(y1, o.y1)};
  }
  Window united(const Window& o) const {
    if (empty()) return o;
    if (o.empty()) return *this;
    return {std::min(x0, o.x0), std::min(y0, o.y0), std::max(x1, o.x1), std::max(y1, o.y1)};
  }

  friend bool operator==(const Window&, const Window&) = default;
};

template <class T>
class Grid {
 public:
  Grid() = default;
  Grid(int width, int height, T value = T())
      : width_(width),
        height_(height),
        data_(std::size_t(width) * height, value) {}

  int width() const { return width_; }
  int height() const { return height_; }
  Window bounds() const { return {0, 0, width_, height_}; }
  T& operator()(int x, int y) { return data_[std::size_t(y) * width_ + x]; }
  const T& operator()(int x, int y) const { return data_[std::size_t(y) * width_ + x]; }
  T* row(int y) { return data_.data() + std::size_t(y) * width_; }
  const T* row(int y) const { return data_.data() + std::size_t(y) * width_; }
  std::vector<T>& data() { return data_; }
  const std::vector<T>& data() const { return data_; }

 private:
  int width_ = 0;
  int height_ = 0;
  std::vector<T> data_;
};

}  // namespace tessera
