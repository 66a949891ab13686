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
  std::size_t silhouette = 0;  // its place in the list that it was made from
  bool mirrored = false;
  Outline outline{};  // shape frame
  float unit_px = 0;  // mask px for one shape unit
  ShapeModel model{};
};

struct SilhouetteLibrary {
  std::vector<KnownSilhouette> shapes;
  std::vector<std::string> left_out;  // silhouettes of which no shape can be made
};

/// The shape of a mask, with its holes, or, where it is all thin lines, of what its outer boundary encloses. Nothing where
/// no shape can be made of it.
std::optional<Shape> shape_of_mask(const cv::Mat& mask);

/// `mirrors`: the mirror image of each is a shape, too.
SilhouetteLibrary make_silhouette_library(const std::vector<Silhouette>& silhouettes, bool mirrors);

}  // namespace tessera::bench
