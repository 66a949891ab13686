// Turns the elements of photographs into drawings for a library: small pictures with transparency, embedded.
#pragma once

#include <cstdint>
#include <opencv2/core.hpp>
#include <string>
#include <vector>

#include "artwork/drawers/drawers.h"
#include "library/library_builder.h"
#include "products/elements/label_roles.h"
#include "products/elements/photo_elements.h"

namespace tessera {

struct CutOut {
  std::string path;   // of no real file: PHOTO_001.png in the photo's path; tells cut-outs apart
  std::string photo;  // path of the photo
  std::vector<std::uint8_t> png;
  std::vector<std::uint8_t> surroundings_png;  // element_surroundings()
  int surroundings_margin_px = 0;
};

/// Cuts out the elements. `picture`, `labels`: see cut_element(). `roles`: of the labels. The numbers are those of the
/// overview.
std::vector<CutOut> cut_outs(const std::string& photo, const cv::Mat& picture, const LabelRuns& labels,
                             const std::vector<LabelRole>& roles, const std::vector<PhotoElement>& elements);

/// A loader for build_library() that takes the cut-outs' paths. Their PNGs become Artwork::original, the photo
/// Artwork::path. Drawers and cut-outs must outlive the loader.
ShapeLoader cut_out_loader(Drawers& drawers, const std::vector<CutOut>& cut_outs, const TracingSettings& settings);

}  // namespace tessera
