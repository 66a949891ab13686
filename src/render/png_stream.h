// Writes a PNG file row by row.
#pragma once

#include <cstdio>
#include <memory>
#include <opencv2/core.hpp>
#include <string>

#include "artwork/images/png_encoder.h"
#include "files/atomic_file.h"
#include "result/picture_file.h"

namespace tessera {

class PngStream : public PictureFile {
 public:
  PngStream(const std::string& path, const PictureFormat& format);

  void write(const cv::Mat& rows) override;
  void finish() override;

 private:
  struct CloseStream {
    void operator()(std::FILE* stream) const { std::fclose(stream); }
  };
  using Stream = std::unique_ptr<std::FILE, CloseStream>;

  static Stream open_stream(const TemporaryFile& file);
  [[noreturn]] void fail(int reason) const;

  std::string path_;
  TemporaryFile file_;
  Stream stream_;  // null: closed
  PngEncoder encoder_;
};

}  // namespace tessera
