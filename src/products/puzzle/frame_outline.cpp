#include "products/puzzle/frame_outline.h"

#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "core/geometry/polygon.h"

namespace tessera {

std::vector<Vec2> frame_outline(const std::vector<std::vector<Vec2>>& edge, const std::string& path) {
  constexpr double kSpeck = 1e-3;  // part of the largest area
  std::vector<double> areas;
  for (const auto& curve : edge) areas.push_back(signed_area(curve));
  const auto by_size = [](double a, double b) { return std::abs(a) < std::abs(b); };
  const auto largest = std::max_element(areas.begin(), areas.end(), by_size);
  if (largest == areas.end() || *largest == 0) throw InputError(path + ": found nothing to cut or to fill");
  const auto others = std::count_if(areas.begin(), areas.end(),
                                    [&](double area) { return std::abs(area) > kSpeck * std::abs(*largest); });
  if (others > 1) {
    throw InputError(path + ": found " + std::to_string(others) +
                     " outlines, of parts or holes; allowed: one silhouette without holes");
  }
  std::vector<Vec2> outline = edge[std::size_t(largest - areas.begin())];
  if (*largest < 0) std::reverse(outline.begin(), outline.end());
  return outline;
}

}  // namespace tessera
