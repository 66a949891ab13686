// A PNG file that is written row by row, so that a picture need not be in memory as a whole.
#pragma once

#include <cstdio>
#include <memory>
#include <opencv2/core.hpp>
#include <string>

namespace tessera::io {

struct PngFormat {
  cv::Size size;       // px
  bool alpha = false;  // 8-bit RGBA, else RGB
  double dpi = 0;      // said in the file; 0 = nothing said
};

/// The file appears at `path` when it is finished, whole or not at all (atomic_file.h).
class PngStream {
 public:
  /// Throws EnvironmentError where the file cannot be written, here and below.
  PngStream(const std::string& path, const PngFormat& format);
  ~PngStream();  // unfinished: removes the temporary file
  PngStream(const PngStream&) = delete;
  PngStream& operator=(const PngStream&) = delete;

  /// The next rows, BGR (CV_8UC3) or with alpha straight BGRA (CV_8UC4), as wide as the picture.
  void write(const cv::Mat& rows);
  /// To be called after the last row.
  void finish();

 private:
  struct Encoder;  // libpng's

  [[noreturn]] void fail(int reason);

  std::string path_;
  std::FILE* file_ = nullptr;
  std::unique_ptr<Encoder> encoder_;
};

}  // namespace tessera::io
