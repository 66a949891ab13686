// The order in which pieces are placed.
#pragma once

#include <algorithm>
#include <vector>

#include "products/nesting/layout/nest_scene.h"

namespace tessera {

/// A measure of how hard a piece is to place: the size of its hull times the longer side of its bounding box.
inline double size_to_place(const PosedShape& shape) { return double(shape.weight) * double(shape.diameter); }

/// Sorts items, the largest first.
inline void order_by_size(const NestScene& scene, std::vector<int>& items) {
  std::stable_sort(items.begin(), items.end(), [&](int a, int b) {
    const double of_a = size_to_place(scene.shape(a, 0)), of_b = size_to_place(scene.shape(b, 0));
    return of_a > of_b || (of_a == of_b && a < b);
  });
}

}  // namespace tessera
