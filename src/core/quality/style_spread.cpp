#include "core/quality/style_spread.h"

#include <map>

namespace tessera {

std::optional<double> mean_style_distance(const std::vector<JudgedPiece>& pieces) {
  std::map<StylePlace, double> area_px2;  // by style
  double all_px2 = 0, squares_px4 = 0;
  for (const JudgedPiece& piece : pieces) {
    if (!piece.style.known()) return {};
    const double own_px2 = piece.scale_px * piece.scale_px;
    area_px2[style_place(piece.style)] += own_px2;
    all_px2 += own_px2;
    squares_px4 += own_px2 * own_px2;
  }
  if (pieces.size() < 2) return {};
  double sum = 0;
  for (auto a = area_px2.begin(); a != area_px2.end(); ++a) {
    for (auto b = area_px2.begin(); b != a; ++b)
      sum += 2 * a->second * b->second * double(style_distance(a->first, b->first));
  }
  return sum / (all_px2 * all_px2 - squares_px4);
}

}  // namespace tessera
