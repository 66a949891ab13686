// Cascades of Haar-like features as Debian's package opencv-data has them, in XML. OpenCV's own parser crashes on damaged
// files.
#pragma once

#include <string>

#include "products/mosaic/haar_cascade.h"

namespace tessera {

/// Throws InputError, which names `path`, where it is no file of a cascade of upright features.
HaarCascade read_haar_cascade(const std::string& path);

}  // namespace tessera
