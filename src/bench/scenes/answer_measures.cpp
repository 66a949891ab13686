#include "bench/scenes/answer_measures.h"

#include <algorithm>
#include <cmath>

#include "core/geometry/closed_curve.h"

namespace tessera::bench {
namespace {

double margin_of(const std::vector<Recognition>& found, const SilhouetteLibrary& library, const Twins& twins) {
  const auto silhouette = [&](const Recognition& r) { return library.shapes[index_of(r.shape)].silhouette; };
  const auto second = std::find_if(found.begin(), found.end(), [&](const Recognition& r) {
    return !twins.are_twins(silhouette(r), silhouette(found.front()));
  });
  return double(found.front().similarity) - (second == found.end() ? 0 : double(second->similarity));
}

double score_of(const ClippedQuery& query, const Recognition& best, const Outline& outline) {
  double of_query = 0;
  for (const Curve& curve : query.curves) of_query += double(length_of(curve));
  double of_shape = 0;
  for (const std::vector<Vec2>& curve : outline.curves) of_shape += double(closed_length(curve));
  return double(best.similarity) * std::sqrt(of_query / (of_shape * double(best.query_from_shape.scale())));
}

}  // namespace

AnswerMeasures answer_measures(const ClippedQuery& query, const std::vector<Recognition>& found,
                               const SilhouetteLibrary& library, const Twins& twins) {
  if (found.empty()) return {};
  const Recognition& best = found.front();
  return {double(best.similarity), margin_of(found, library, twins),
          score_of(query, best, library.shapes[index_of(best.shape)].outline)};
}

}  // namespace tessera::bench
