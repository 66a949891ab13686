// Writes PNGs with libpng, row by row: to a file (render/png_stream.h) or to memory.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <opencv2/core.hpp>
#include <span>
#include <vector>

namespace tessera {

/// The way in which libpng's filters and zlib compress the rows.
enum class PngPacking {
  small,   // the smallest file, for drawings
  labels,  // the smallest file, for areas of one value each
  fast     // the shortest time
};

struct PngFormat {
  cv::Size size;            // in px
  int type = CV_8UC4;       // OpenCV's type of the rows: 8 or 16 bits; grey, BGR or straight BGRA
  cv::Size2d size_mm = {};  // size on paper, written into the file; 0 x 0: not written
  PngPacking packing = PngPacking::fast;
};

class PngEncoder {
 public:
  /// Takes the next bytes of the file; returns false where it cannot. An exception counts as false.
  using Sink = std::function<bool(std::span<const std::uint8_t>)>;

  explicit PngEncoder(Sink sink);
  ~PngEncoder();

  /// All three return false where `sink` failed or libpng cannot make such a file. begin() is called first, end() after
  /// the last row.
  bool begin(const PngFormat& format);
  bool write(const cv::Mat& rows);
  bool end();

 private:
  struct State;  // libpng's
  std::unique_ptr<State> state_;
};

/// A PNG in memory, compressed fast. `image`: 8 or 16 bits; grey, BGR or straight BGRA. Throws EnvironmentError where
/// it cannot be made.
std::vector<std::uint8_t> png_of(const cv::Mat& image);

}  // namespace tessera
