// How often each shape may stand, and how often it must: what the job says, or a wish for the shape itself.
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

  /// Whether it matters at all how often a shape stands.
  bool any() const { return any_; }
  /// At most so many pieces of the shape; 0 = no limit.
  int most(ShapeId shape) const { return of_class(shape).most; }
  /// At least so many. With fit = "all" that is 1 or more.
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
  std::vector<std::uint32_t> class_of_shape_;  // empty: all of class 0
};

}  // namespace tessera
