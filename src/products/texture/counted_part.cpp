#include "products/texture/counted_part.h"

namespace tessera {

CountedPart::CountedPart(const CanvasPart& part)
    : stride_(std::size_t(part.above.cols) + 1),
      before_(stride_ * std::size_t(part.above.rows)) {
  for (int y = 0; y < part.above.rows; ++y) {
    const int* above = part.above.ptr<int>(y);
    const std::uint8_t* below = part.below.ptr(y);
    CellCounts* counts = &before_[std::size_t(y) * stride_];
    for (int x = 0; x < part.above.cols; ++x) {
      const bool is_free = above[x] == 0;
      counts[x + 1] = {x + 1, counts[x].taken + !is_free, counts[x].hole + (is_free && below[x] == kHole),
                       counts[x].unlaid + (is_free && below[x] != kLaidGround)};
    }
  }
}

}  // namespace tessera
