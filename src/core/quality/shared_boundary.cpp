#include "core/quality/shared_boundary.h"

#include <algorithm>
#include <cmath>

#include "core/base/rank_pool.h"
#include "core/field/field_lookup.h"
#include "core/quality/boundary_grid.h"

namespace tessera {

double shared_boundary_fraction(const Canvas& canvas, const std::vector<JudgedPiece>& pieces, float reach_px) {
  const std::vector<EdgeSample> samples = edge_samples(canvas, pieces, reach_px);
  if (samples.empty()) return 0;
  const BoundaryGrid grid(samples, reach_px);
  const FieldView edge(canvas.distance);
  const auto shared = [&](const EdgeSample& s) {
    return !s.image && (std::abs(field_value(edge, s.position_px)) <= reach_px || grid.another_piece_near(s));
  };
  const auto is_counted = [](const EdgeSample& s) { return !s.image; };
  return double(std::count_if(samples.begin(), samples.end(), shared)) /
         double(std::count_if(samples.begin(), samples.end(), is_counted));
}

std::vector<float> boundary_distances_px(const Canvas& canvas, const std::vector<JudgedPiece>& pieces, float reach_px) {
  const std::vector<EdgeSample> samples = edge_samples(canvas, pieces, reach_px);
  if (samples.empty()) return {};
  const BoundaryGrid grid(samples, reach_px);
  const FieldView edge(canvas.distance);
  std::vector<std::vector<float>> by_piece(pieces.size());
  parallel_for(pieces.size(), [&](std::size_t k) {
    for (const std::vector<Vec2>& curve : pieces[k].outline_px.curves) {
      for (const Vec2 p : curve) {
        const Vec2 home = canvas.period.wrapped(p);
        const float edge_px = std::abs(field_value(edge, home));
        by_piece[k].push_back(std::min(edge_px, grid.distance_to_another_px(home, std::uint32_t(k))));
      }
    }
  });
  std::vector<float> all;
  for (const std::vector<float>& distances : by_piece) all.insert(all.end(), distances.begin(), distances.end());
  return all;
}

}  // namespace tessera
