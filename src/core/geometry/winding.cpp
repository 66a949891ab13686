#include "core/geometry/winding.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace tessera {
namespace {

constexpr double kFewestLines = 16;
constexpr double kMostLines = 128;

/// The boundary crosses a line at x, upwards (+1) or downwards (-1).
struct LineCrossing {
  int line;
  double x;
  int turn;

  bool operator<(const LineCrossing& o) const { return std::tie(line, x) < std::tie(o.line, o.x); }
};

/// Horizontal lines, evenly spaced between the lowest and the highest y.
struct Lines {
  double first_y = 0;
  double apart = 1;
  int count = 0;
};

Lines lines_across(const Outline& outline) {
  double low = INFINITY, high = -INFINITY;
  for (const std::vector<Vec2>& curve : outline.curves) {
    for (const Vec2 p : curve) {
      low = std::min(low, double(p.y));
      high = std::max(high, double(p.y));
    }
  }
  if (!(high > low)) return {};
  const int count = int(std::clamp((high - low) / 2, kFewestLines, kMostLines));
  const double apart = (high - low) / count;
  return {low + apart / 2, apart, count};
}

void add_crossings(Vec2 from, Vec2 to, const Lines& lines, std::vector<LineCrossing>& crossings) {
  const int turn = to.y > from.y ? 1 : -1;
  if (turn < 0) std::swap(from, to);
  const int begin = std::max(0, int(std::ceil((from.y - lines.first_y) / lines.apart)));
  const int end = std::min(lines.count, int(std::ceil((to.y - lines.first_y) / lines.apart)));
  for (int line = begin; line < end; ++line) {
    const double y = lines.first_y + line * lines.apart;
    crossings.push_back({line, from.x + (to.x - from.x) * (y - from.y) / (to.y - from.y), turn});
  }
}

}  // namespace

double twisted_area(const Outline& outline) {
  const Lines lines = lines_across(outline);
  std::vector<LineCrossing> crossings;
  for (const std::vector<Vec2>& curve : outline.curves) {
    for (std::size_t i = 0, j = curve.size() - 1; i < curve.size(); j = i++) {
      add_crossings(curve[j], curve[i], lines, crossings);
    }
  }
  std::sort(crossings.begin(), crossings.end());
  double length = 0;
  int winding = 0;  // winding number behind the crossing; a closed curve ends each line with 0
  for (std::size_t i = 0; i + 1 < crossings.size(); ++i) {
    winding -= crossings[i].turn;
    if (winding != 0 && winding != 1) length += crossings[i + 1].x - crossings[i].x;
  }
  return length * lines.apart;
}

}  // namespace tessera
