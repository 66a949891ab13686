// Makes a library shape from an artwork file.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <variant>

#include "core/shape/outline.h"
#include "core/shape/shape.h"
#include "core/style/style_features.h"

namespace tessera {

/// A shape, and what of its artwork is not part of it.
struct ArtworkShape {
  Shape shape;                    // name: the file name without extension; Artwork::original stays empty
  int other_components = 0;       // parts that touch it nowhere, translucent ones too
  float other_area_fraction = 0;  // see TracedOutline
  bool loses_parts = false;       // see SolidCoverage
  bool loses_text = false;        // not drawn, as this machine has no font
  bool loses_pictures = false;    // the file has more of them than its first
  float hollowness = 1;           // see TracedOutline
  StyleFeatures style = {};       // what the drawing looks like
};

struct TracingSettings {
  PadParameters pad;
  TracingRules rules = {};
};

/// `bytes` is the content of the file `path` (read_artwork_file). Two files with the same silhouette give equal
/// Shape::outline. Throws InputError where it is no artwork, or nothing but
/// text that this machine has no font for; a drawing that is of no use gives the reason.
std::variant<ArtworkShape, SkipReason> shape_from_artwork(std::span<const std::uint8_t> bytes, const std::string& path,
                                                          const TracingSettings& settings);

}  // namespace tessera
