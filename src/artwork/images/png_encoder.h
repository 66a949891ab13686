// Writes PNGs through libpng, row by row: to a file (render/png_stream.h) or to memory.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <opencv2/core.hpp>
#include <span>
#include <vector>

namespace tessera {

/// How libpng's filter and zlib pack the rows.
enum class PngPacking {
  small,   // the smallest file, for drawings
  labels,  // the smallest file, for areas of one value each
  fast     // the shortest time
};

struct PngFormat {
  cv::Size size;            // in px
  int type = CV_8UC4;       // OpenCV's type of the rows: 8 or 16 bits; grey, BGR or straight BGRA
  cv::Size2d size_mm = {};  // the size on paper, which the file tells; 0 x 0: it tells none
  PngPacking packing = PngPacking::fast;
};

class PngEncoder {
 public:
  /// Takes the next bytes of the file; false where that cannot be. An exception counts as false.
  using Sink = std::function<bool(std::span<const std::uint8_t>)>;

  explicit PngEncoder(Sink sink);
  ~PngEncoder();

  /// All three are false where `sink` failed, or where libpng cannot make such a file. begin() is called first, end()
  /// after the last row.
  bool begin(const PngFormat& format);
  bool write(const cv::Mat& rows);
  bool end();

 private:
  struct State;  // libpng's
  std::unique_ptr<State> state_;
};

/// A PNG in memory, packed fast. `image`: 8 or 16 bits; grey, BGR or straight BGRA. Throws EnvironmentError where that
/// cannot be.
std::vector<std::uint8_t> png_of(const cv::Mat& image);

}  // namespace tessera
