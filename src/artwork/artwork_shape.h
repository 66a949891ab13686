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

/// A shape, and the parts of its artwork that it leaves out.
struct ArtworkShape {
  Shape shape;                    // name: the file name without extension; Artwork::original stays empty
  int other_components = 0;       // parts that do not touch the shape, translucent ones included
  float other_area_fraction = 0;  // see TracedOutline
  bool loses_parts = false;       // see SolidCoverage
  bool loses_text = false;        // text was not drawn, as this machine has no font
  bool loses_pictures = false;    // the file has more pictures than the first one
  float hollowness = 1;           // see TracedOutline
  StyleFeatures style = {};       // of the whole drawing
};

struct TracingSettings {
  PadParameters pad;
  TracingRules rules = {};
};

/// Traces the shape of an artwork file. `bytes` is the content of the file `path` (read_artwork_file). Two files with
/// the same silhouette give equal Shape::outline. Returns the reason where the drawing cannot be a shape. Throws
/// InputError where the bytes are no artwork, or only text for which this machine has no font.
std::variant<ArtworkShape, SkipReason> shape_from_artwork(std::span<const std::uint8_t> bytes, const std::string& path,
                                                          const TracingSettings& settings);

}  // namespace tessera
