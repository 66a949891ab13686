// Finds faces in a picture, by a cascade of OpenCV's data (haar_cascade.h), which is in Debian's package opencv-data.
#pragma once

#include <opencv2/core.hpp>
#include <string>
#include <vector>

#include "products/mosaic/haar_cascade.h"

namespace tessera {

struct Face {
  cv::Rect2d box;        // from the brows to the chin; in parts of the picture's width and height
  double certainty = 0;  // above 0, at most 1
};

/// The path of the cascade: in the folder that TESSERA_CASCADES names, else in Debian's.
std::string face_cascade_file();

/// Finds upright faces seen from the front, the surest first; none narrower than the part `narrowest` of the picture's
/// width. `image_bgr`: CV_8UC3. `cascade`: from face_cascade_file().
std::vector<Face> find_faces(const cv::Mat& image_bgr, const HaarCascade& cascade, double narrowest);

}  // namespace tessera
