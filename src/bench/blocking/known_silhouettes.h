// Whole silhouettes as the shapes of a library that queries are compared with.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "bench/blocking/silhouettes.h"
#include "core/geometry/polygon.h"
#include "core/shape/shape_model.h"

namespace tessera::bench {

struct KnownSilhouette {
  std::size_t silhouette = 0;  // its index in the list of silhouettes
  bool mirrored = false;
  Outline outline{};  // shape frame
  float unit_px = 0;  // mask px in one shape unit
  ShapeModel model{};
};

struct SilhouetteLibrary {
  std::vector<KnownSilhouette> shapes;
  std::vector<std::string> left_out;  // silhouettes that give no shape
};

/// The shape of a mask, with its holes. Where the mask consists of thin lines it is the area within the outer boundary.
/// Nullopt where it gives no shape.
std::optional<Shape> shape_of_mask(const cv::Mat& mask);

/// Makes the library. `mirrors`: the mirror image of each silhouette is a shape, too.
SilhouetteLibrary make_silhouette_library(const std::vector<Silhouette>& silhouettes, bool mirrors);

}  // namespace tessera::bench
