#include "core/quality/variety.h"

#include <cmath>
#include <map>
#include <string>

namespace tessera {

std::optional<double> effective_shapes(const std::vector<JudgedPiece>& pieces) {
  std::map<std::string, double> area_px2;
  double all_px2 = 0;
  for (const JudgedPiece& piece : pieces) {
    if (piece.shape.empty()) continue;
    area_px2[piece.shape] += piece.scale_px * piece.scale_px;
    all_px2 += piece.scale_px * piece.scale_px;
  }
  if (area_px2.empty()) return {};
  double entropy = 0;
  for (const auto& [shape, of_shape_px2] : area_px2) {
    const double share = of_shape_px2 / all_px2;
    if (share > 0) entropy -= share * std::log(share);
  }
  return std::exp(entropy);
}

}  // namespace tessera
