#include "recognition/answer_score.h"

#include <cmath>

#include "core/geometry/closed_curve.h"

namespace tessera {

double answer_score(const Recognition& answer, const std::vector<Curve>& query, const Outline& outline) {
  double of_query = 0;
  for (const Curve& curve : query) of_query += double(length_of(curve));
  double of_shape = 0;
  for (const std::vector<Vec2>& curve : outline.curves) of_shape += double(closed_length(curve));
  return double(answer.similarity) * std::sqrt(of_query / (of_shape * double(answer.query_from_shape.scale())));
}

}  // namespace tessera
