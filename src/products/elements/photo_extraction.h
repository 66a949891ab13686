// Extracts the elements of one photo file, for tessera library extract.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "artwork/drawers/drawers.h"
#include "products/elements/cut_outs.h"
#include "products/elements/element_labels.h"
#include "products/elements/photo_elements.h"

namespace tessera {

/// The largest photo file that is read.
inline constexpr std::size_t kMaxPhotoBytes = std::size_t(128) << 20;

inline constexpr int kMostEnlarged = 8;

/// Settings. All px are those of the original photo, whatever `enlarged` is.
struct ExtractionSettings {
  /// Short side of a typical element, px, for the search; not used with `labels`. 0: found, unless the elements lie apart
  /// on a plain ground, which needs no size.
  double element_px = 0;
  ElementSizes sizes;
  // factor, 1 to kMostEnlarged, by which the photo is enlarged before it is searched, cut up and shown
  int enlarged = 1;
  // where not 0: enlarged so far, at most `most_enlarged` times, that usual elements are so wide, px, and seven of eight
  // large enough for a library
  double enlarged_element_px = 0;
  int most_enlarged = kMostEnlarged;
  double most_enlarged_px2 = 1e9;  // of the enlarged photo
  std::string labels;              // path of a label map from another program, used instead of a search; empty: none
  bool with_overview = false;      // also make the picture of what was found
  int ground_px = 0;               // side of the picture of the ground; 0: none
};

struct Extraction {
  FoundElements found;
  // elements that look like several touching ones, where no size tells how to separate them
  std::size_t touching = 0;
  std::vector<CutOut> cut_outs;
  std::shared_ptr<const LabelRuns> labels;  // of the photo, enlarged
  std::vector<LabelRole> roles;             // of the labels
  std::vector<std::uint8_t> overview_png;   // empty without with_overview
  std::vector<std::uint8_t> ground_png;     // empty without ground_px, or where there is a ground_problem
  std::string ground_problem;               // why there is no picture of the ground: the photo shows too little of it
  double element_px = 0;                    // the short side that was searched for; 0: none
  int enlarged = 1;                         // how many times
  double ground_part = 0;                   // part of the photo that is ground, with ground_px
  /// Elements smaller than this were left out: square root of the area, px of the photo. At least what a library accepts.
  double least_px = 0;
};

/// Throws InputError where a file is no photo or no label map of its size; where no size is given and the ground is not
/// plain, and no size at which elements are found; where elements are too small for the photo; or where the photo would be
/// too large when enlarged.
Extraction extract_elements(const std::string& photo, const ExtractionSettings& settings, Drawers& drawers);

}  // namespace tessera
