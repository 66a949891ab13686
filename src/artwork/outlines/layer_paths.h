// The paths in what cairo writes of a drawn layer (flattened_svg.h tells how), with what cuts them.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "artwork/svg/path_steps.h"

namespace tessera {

struct LayerClip {
  PathSteps steps;
  bool even_odd = false;
};

struct LayerPath {
  PathSteps steps = {};  // in units of the layer
  bool filled = false;
  bool stroked = false;
  bool even_odd = false;                                // the rule by which it is filled
  std::vector<std::shared_ptr<const LayerClip>> clips;  // it is seen where all of them are
};

/// The paths of an SVG that cairo has written, in the order in which they are painted. Paths that are fully transparent are
/// not among them. Bitmaps, masks and what is painted without a path are passed over. Throws InputError where cairo does
/// not write such a text, or where it is too much.
std::vector<LayerPath> layer_paths(const std::string& svg);

}  // namespace tessera
