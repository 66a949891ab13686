// Writes a TIFF for viewers of large pictures: in tiles, with smaller copies of the picture at half, a quarter ... of its
// size.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "files/atomic_file.h"
#include "result/picture_file.h"

namespace tessera {

/// Tiles of 256 x 256 px, deflated. Each smaller copy is a directory of its own (reduced image); the last one fits into a
/// tile. The file is a BigTIFF where it may need more than 4 GB.
class TiffPyramid : public PictureFile {
 public:
  TiffPyramid(const std::string& path, const PictureFormat& format);
  ~TiffPyramid() override;
  TiffPyramid(const TiffPyramid&) = delete;
  TiffPyramid& operator=(const TiffPyramid&) = delete;

  void write(const cv::Mat& rows) override;
  void finish() override;

 private:
  class Level;

  void add_rows(std::size_t level, const cv::Mat& rows);
  void append(Level& level);

  std::string path_;
  TemporaryFile file_;
  std::vector<std::unique_ptr<Level>> levels_;  // from the whole picture to the smallest
};

}  // namespace tessera
