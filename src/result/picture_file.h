// Writes a picture to a file some rows at a time, so that it need not be in memory as a whole.
#pragma once

#include <opencv2/core.hpp>

namespace tessera {

struct PictureFormat {
  cv::Size size;            // px
  bool alpha = false;       // 8-bit RGBA with straight alpha; otherwise RGB
  cv::Size2d size_mm = {};  // size on paper, written into the file; 0 x 0: none is written
  int grey_bits = 0;        // 8 or 16: grey instead of colours (only PngStream)
};

/// The file appears under its name when it is finished, whole or not at all (atomic_file.h). All members throw
/// EnvironmentError where it cannot be written.
class PictureFile {
 public:
  virtual ~PictureFile() = default;  // an unfinished file leaves nothing

  /// Writes the next rows, as wide as the picture: BGR (CV_8UC3), with alpha straight BGRA (CV_8UC4), or grey (CV_8UC1,
  /// CV_16UC1).
  virtual void write(const cv::Mat& rows) = 0;
  /// Finishes the file. To be called after the last row.
  virtual void finish() = 0;
};

}  // namespace tessera
