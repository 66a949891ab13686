#include "core/matching/use_limits.h"

#include <algorithm>

namespace tessera {

UseLimits::UseLimits(const PieceSettings& pieces, const Wishes& wishes)
    : any_(pieces.fit_all || pieces.uses > 0 || pieces.least_uses > 0),
      class_of_shape_(wishes.class_of_shape) {
  std::vector<ShapeWish> classes = wishes.classes;
  if (classes.empty()) classes.emplace_back();
  for (const ShapeWish& wish : classes) {
    const int most = wish.uses.value_or(pieces.uses);
    const int least = std::max(wish.least_uses.value_or(pieces.least_uses), int(pieces.fit_all));
    classes_.push_back({most > 0 ? std::min(least, most) : least, most});
    any_ = any_ || classes_.back().least > 0 || classes_.back().most > 0;
  }
}

}  // namespace tessera
