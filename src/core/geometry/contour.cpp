#include "core/geometry/contour.h"

#include <algorithm>
#include <cstdint>

namespace tessera {
namespace {

// A cell's corners and sides are numbered around it in the positive sense: corner 0 is the node the cell is named
// after, side k leads from corner k to corner k + 1. A contour enters a cell through a side on which the value falls
// below the level and leaves it through one on which it rises.
constexpr int kCornerX[4] = {0, 1, 1, 0};
constexpr int kCornerY[4] = {0, 0, 1, 1};
constexpr int kAcrossX[4] = {0, 1, 0, -1};  // the neighbour on the other side
constexpr int kAcrossY[4] = {-1, 0, 1, 0};

struct Entry {
  int x = 0;
  int y = 0;
  int side = 0;

  friend bool operator==(const Entry&, const Entry&) = default;
};

class Tracer {
 public:
  Tracer(const Grid<float>& value, float level)
      : value_(value.width() + 2, value.height() + 2),
        visited_(value_.width(), value_.height()),
        level_(level) {
    for (int y = 0; y < value.height(); ++y) {
      std::copy_n(value.row(y), value.width(), value_.row(y + 1) + 1);
    }
  }

  std::vector<std::vector<Vec2>> all() {
    std::vector<std::vector<Vec2>> found;
    for (int y = 0; y + 1 < value_.height(); ++y) {
      for (int x = 0; x + 1 < value_.width(); ++x) {
        if (uncrossed(x, y)) continue;
        for (int side = 0; side < 4; ++side) {
          const Entry start{x, y, side};
          if (enters(start) && !visited(start)) found.push_back(trace(start));
        }
      }
    }
    return found;
  }

 private:
  float corner(int x, int y, int k) const { return value_(x + kCornerX[k & 3], y + kCornerY[k & 3]); }
  bool inside(int x, int y, int k) const { return corner(x, y, k) >= level_; }
  bool enters(const Entry& e) const { return inside(e.x, e.y, e.side) && !inside(e.x, e.y, e.side + 1); }
  bool visited(const Entry& e) const { return visited_(e.x, e.y) >> e.side & 1; }

  bool uncrossed(int x, int y) const {
    const bool first = inside(x, y, 0);
    return first == inside(x, y, 1) && first == inside(x, y, 2) && first == inside(x, y, 3);
  }

  std::vector<Vec2> trace(const Entry& start) {
    std::vector<Vec2> curve;
    Entry at = start;
    do {
      visited_(at.x, at.y) |= std::uint8_t(1 << at.side);
      curve.push_back(crossing(at));
      at = next(at);
    } while (!(at == start));
    return curve;
  }

  Entry next(const Entry& e) const {
    const int side = exit_side(e);
    return {e.x + kAcrossX[side], e.y + kAcrossY[side], (side + 2) & 3};
  }

  int exit_side(const Entry& e) const {
    if (inside(e.x, e.y, e.side + 2) && !inside(e.x, e.y, e.side + 3)) {  // a saddle
      const float sum = corner(e.x, e.y, 0) + corner(e.x, e.y, 1) + corner(e.x, e.y, 2) + corner(e.x, e.y, 3);
      return (e.side + (sum >= 4 * level_ ? 1 : 3)) & 3;
    }
    int side = e.side + 1;
    while (!inside(e.x, e.y, side + 1)) ++side;
    return side & 3;
  }

  Vec2 crossing(const Entry& e) const {
    const int k = e.side, l = (e.side + 1) & 3;
    const float from = corner(e.x, e.y, k), to = corner(e.x, e.y, l);
    // A small distance from the nodes, so that neighbouring crossings never coincide.
    const float t = std::clamp((from - level_) / (from - to), 1e-3f, 1 - 1e-3f);
    return {float(e.x - 1) + kCornerX[k] + t * (kCornerX[l] - kCornerX[k]),
            float(e.y - 1) + kCornerY[k] + t * (kCornerY[l] - kCornerY[k])};
  }

  Grid<float> value_;  // with a rim of zeros
  Grid<std::uint8_t> visited_;
  float level_;
};

}  // namespace

std::vector<std::vector<Vec2>> contours(const Grid<float>& value, float level) { return Tracer(value, level).all(); }

}  // namespace tessera
