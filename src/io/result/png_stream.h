// A PNG file that is written row by row.
#pragma once

#include <cstdio>
#include <memory>
#include <opencv2/core.hpp>
#include <string>

#include "io/result/picture_file.h"

namespace tessera::io {

class PngStream : public PictureFile {
 public:
  PngStream(const std::string& path, const PictureFormat& format);
  ~PngStream() override;
  PngStream(const PngStream&) = delete;
  PngStream& operator=(const PngStream&) = delete;

  void write(const cv::Mat& rows) override;
  void finish() override;

 private:
  struct Encoder;  // libpng's

  [[noreturn]] void fail(int reason);

  std::string path_;
  std::FILE* file_ = nullptr;
  std::unique_ptr<Encoder> encoder_;
};

}  // namespace tessera::io
