// The paths that cairo writes for a drawn layer (see flattened_svg.h), with their clips.
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
  bool even_odd = false;                                // the fill rule
  std::vector<std::shared_ptr<const LayerClip>> clips;  // it is visible inside all of them
};

/// The paths of an SVG that cairo has written, in the order of painting. Fully transparent paths, bitmaps, masks and
/// painting without a path are left out. Throws InputError where cairo does not write such a text, or where a limit is
/// exceeded.
std::vector<LayerPath> layer_paths(const std::string& svg);

}  // namespace tessera
