// The few data that identify a shape of a library, and the digest of a library that is made of them.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "core/pad/pad.h"
#include "core/style/style_features.h"
#include "library/storage/library_layout.h"

namespace tessera {

/// Digests of a shape's outline, field and smoothing levels (part_digest.h).
using PartDigests = std::array<std::uint64_t, layout::kPartDigests>;

struct ShapeHead {
  std::string name;
  float perimeter = 0;  // shape units
  float radius = 0;     // shape units
  std::array<float, 3> mean_lab{};
  PartDigests part_digest{};
  std::uint32_t variant_of = 0;  // the first shape of the library with the same silhouette
  float drawn_scale_px = 0;      // 0: unknown
  StyleFeatures style = {};

  std::uint64_t outline_digest() const { return part_digest[0]; }
};

/// ShapeLibrary::content_digest() of so many shapes; `heads` returns the heads of any range. Variants are added only where
/// there are any, and the sizes of drawings do not count (see LibraryChoice): so the digests of older libraries stay the
/// same.
std::uint64_t digest_of_heads(const PadParameters& pad, std::size_t shapes,
                              const std::function<std::vector<ShapeHead>(std::size_t begin, std::size_t end)>& heads);

}  // namespace tessera
