// Limits of the number of pieces of each shape: the largest and the least number, from the job or from a wish for the
// shape.
#pragma once

#include <cstdint>
#include <vector>

#include "core/settings/settings.h"
#include "core/settings/wishes.h"
#include "core/shape/shape_id.h"

namespace tessera {

class UseLimits {
 public:
  UseLimits(const PieceSettings& pieces, const Wishes& wishes);

  /// Whether any limit exists.
  bool any() const { return any_; }
  /// The largest number of pieces of the shape; 0 = no limit.
  int most(ShapeId shape) const { return of_class(shape).most; }
  /// The least number of pieces of the shape; 1 or more with fit = "all".
  int least(ShapeId shape) const { return of_class(shape).least; }

 private:
  struct Limits {
    int least = 0;
    int most = 0;
  };
  const Limits& of_class(ShapeId shape) const {
    return classes_[class_of_shape_.empty() ? 0 : class_of_shape_[index_of(shape)]];
  }

  bool any_ = false;
  std::vector<Limits> classes_;
  std::vector<std::uint32_t> class_of_shape_;  // empty: all shapes are of class 0
};

}  // namespace tessera
