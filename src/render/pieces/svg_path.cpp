#include "render/pieces/svg_path.h"

#include "text/number_text.h"

namespace tessera {

std::string svg_path(const std::vector<std::vector<Vec2>>& curves, const Similarity& target_from_source) {
  std::string data;
  for (const std::vector<Vec2>& curve : curves) {
    for (std::size_t i = 0; i < curve.size(); ++i) {
      const Vec2 p = target_from_source.apply(curve[i]);
      data += i ? 'L' : 'M';
      data += fixed(p.x, 3) + " " + fixed(p.y, 3);
    }
    data += 'Z';
  }
  return data;
}

}  // namespace tessera
