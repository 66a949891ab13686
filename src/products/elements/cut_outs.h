// The elements of photographs as drawings that a library can be built from: small pictures with transparency, embedded.
#pragma once

#include <cstdint>
#include <opencv2/core.hpp>
#include <string>
#include <vector>

#include "artwork/drawers/drawers.h"
#include "library/library_builder.h"
#include "products/elements/photo_elements.h"

namespace tessera {

struct CutOut {
  std::string path;   // of no file: that of the photo, and in it PHOTO_001.png; tells cut-outs apart
  std::string photo;  // path
  std::vector<std::uint8_t> png;
};

/// `picture`, `labels`: see cut_element. Numbers are those of the overview.
std::vector<CutOut> cut_outs(const std::string& photo, const cv::Mat& picture, const LabelRuns& labels,
                             const std::vector<PhotoElement>& elements);

/// For build_library, of the cut-outs' paths. Their PNGs become Artwork::original, the photo Artwork::path. Drawers and
/// cut-outs must outlive the loader.
ShapeLoader cut_out_loader(Drawers& drawers, const std::vector<CutOut>& cut_outs, const TracingSettings& settings);

}  // namespace tessera
