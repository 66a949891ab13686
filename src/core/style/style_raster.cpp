#include "core/style/style_raster.h"

#include <utility>
#include <vector>

namespace tessera {

Grid<std::uint8_t> enclosed_by(const Grid<float>& alpha) {
  Grid<std::uint8_t> inside(alpha.width(), alpha.height(), 1);
  std::vector<std::pair<int, int>> reached;
  const auto reach = [&](int x, int y) {
    if (!alpha.bounds().contains(x, y) || inside(x, y) == 0 || alpha(x, y) >= 0.5f) return;
    inside(x, y) = 0;
    reached.emplace_back(x, y);
  };
  for (int x = 0; x < alpha.width(); ++x) {
    reach(x, 0);
    reach(x, alpha.height() - 1);
  }
  for (int y = 0; y < alpha.height(); ++y) {
    reach(0, y);
    reach(alpha.width() - 1, y);
  }
  while (!reached.empty()) {
    const auto [x, y] = reached.back();
    reached.pop_back();
    reach(x - 1, y);
    reach(x + 1, y);
    reach(x, y - 1);
    reach(x, y + 1);
  }
  return inside;
}

}  // namespace tessera
