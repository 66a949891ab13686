// From a photo's file to its elements, cut out: what tessera library extract does with each photo.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "artwork/drawers/drawers.h"
#include "products/elements/cut_outs.h"
#include "products/elements/element_labels.h"
#include "products/elements/photo_elements.h"

namespace tessera {

/// Of a photo's file.
inline constexpr std::size_t kMaxPhotoBytes = std::size_t(128) << 20;

inline constexpr int kMostEnlarged = 8;

/// All px are those of the photo as it is, whatever `enlarged` is.
struct ExtractionSettings {
  /// The short side of a typical element, px, for the search; not used with `labels`. 0: no search, as elements lie apart on
  /// a plain ground.
  double element_px = 0;
  ElementSizes sizes;
  int enlarged = 1;            // times, 1 to kMostEnlarged: the photo is searched, cut up and shown so
  std::string labels;          // path of a map from another program, instead of searching; empty = none
  bool with_overview = false;  // the picture of what was found
  int ground_px = 0;           // side of the picture of the ground; 0 = none is made
};

struct Extraction {
  FoundElements found;
  std::size_t touching = 0;  // elements that look like several which touch, where no size says how to tell them apart
  std::vector<CutOut> cut_outs;
  std::vector<std::uint8_t> overview_png;  // empty without with_overview
  std::vector<std::uint8_t> ground_png;    // empty without ground_px
  double ground_part = 0;                  // of the photo that is ground, with ground_px
  /// What is smaller was left out: square root of the area, px of the photo. At least what a library takes.
  double least_px = 0;
};

/// Throws InputError where a file is no photo or no map of its size, where no size is given and the
/// ground is not plain, where elements are too small for the photo, where
/// it would be too large when enlarged, or where it shows not enough ground.
Extraction extract_elements(const std::string& photo, const ExtractionSettings& settings, Drawers& drawers);

}  // namespace tessera
