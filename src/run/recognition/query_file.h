// The outlines of what a picture shows, as a query of recognition.
#pragma once

#include <string>
#include <vector>

#include "artwork/drawers/drawers.h"
#include "core/recognition/curve.h"

namespace tessera {

struct QueryFile {
  std::string path;
  std::vector<Curve> outlines;  // closed; pixels of the picture as it was drawn for tracing
  float traced_per_px = 1;      // such pixels for one px of the picture's own (of an SVG: 1/96 inch)
};

/// All outlines of an SVG, an image with transparency, a mask or a picture on a plain background, holes too. Outlines that
/// enclose little are left out. Throws InputError, which names the file, where there is none.
QueryFile read_query_file(Drawers& drawers, const std::string& path);

}  // namespace tessera
