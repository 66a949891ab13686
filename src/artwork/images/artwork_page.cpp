#include "artwork/images/artwork_page.h"

#include <algorithm>
#include <cmath>

namespace tessera {

cv::Size page_size_px(const ArtworkPage& page, int longest_side_px) {
  const cv::Size2d natural = page.natural_size();
  const double scale = longest_side_px / std::max(natural.width, natural.height);
  // The longest side must be exact: a rounding error must not add a column.
  const auto side = [&](double length) { return std::max(1, int(std::ceil(length * scale - 1e-6))); };
  return {side(natural.width), side(natural.height)};
}

}  // namespace tessera
