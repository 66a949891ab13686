// Reads cascades of Haar-like features in the XML of Debian's package opencv-data. OpenCV's own parser crashes on damaged
// files.
#pragma once

#include <string>

#include "products/mosaic/haar_cascade.h"

namespace tessera {

/// Throws InputError that names `path` where it is no file of a cascade of upright features.
HaarCascade read_haar_cascade(const std::string& path);

}  // namespace tessera
