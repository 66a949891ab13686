#include "recognition/answer_score.h"

#include <cmath>

#include "core/geometry/closed_curve.h"

namespace tessera {

double answer_score(const Recognition& answer, const Outline& outline) {
  double of_shape = 0;
  for (const std::vector<Vec2>& curve : outline.curves) of_shape += double(closed_length(curve));
  const double followed = double(answer.similarity) * double(answer.query_length);
  return followed / std::sqrt(double(answer.query_length) * of_shape * double(answer.query_from_shape.scale()));
}

}  // namespace tessera
