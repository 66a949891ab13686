#include "core/recognition/curve_points.h"

#include <algorithm>

namespace tessera {

CurvePoints::CurvePoints(std::span<const Curve> curves) {
  float length = 0;
  for (const Curve& curve : curves) {
    const std::vector<Vec2> tangents = tangents_of(curve);
    length += length_of(curve);
    position_.insert(position_.end(), curve.points.begin(), curve.points.end());
    tangent_.insert(tangent_.end(), tangents.begin(), tangents.end());
  }
  spacing_ = length / float(std::max<std::size_t>(position_.size(), 1));
}

void CurvePoints::add_opposite() {
  const std::size_t count = position_.size();
  position_.reserve(2 * count);
  tangent_.reserve(2 * count);
  for (std::size_t i = 0; i < count; ++i) {
    position_.push_back(position_[i]);
    tangent_.push_back(tangent_[i] * -1);
  }
}

}  // namespace tessera
