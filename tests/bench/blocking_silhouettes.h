// Silhouettes drawn from formulas, as the benchmark `blocking` reads them.
#pragma once

#include <cmath>
#include <fstream>
#include <numbers>
#include <opencv2/imgproc.hpp>
#include <string>
#include <vector>

#include "artwork/images/png_encoder.h"
#include "core/replacing/draws.h"
#include "support/scratch_folder.h"

namespace tessera::test {

/// A white blob on black, about 150 px wide. The same number gives the same blob; its left and right halves differ.
inline cv::Mat blob_mask(std::uint64_t number) {
  Draws draws(number);
  std::vector<double> amplitude, phase;
  for (int wave = 2; wave < 9; ++wave) {
    amplitude.push_back((10 + 20 * double(draws.unit())) / wave);
    phase.push_back(2 * std::numbers::pi * double(draws.unit()));
  }
  std::vector<cv::Point> points;
  for (int i = 0; i < 720; ++i) {
    const double angle = i * std::numbers::pi / 360;
    double radius = 65;
    for (int k = 0; k < 7; ++k) radius += amplitude[std::size_t(k)] * std::cos((k + 2) * angle + phase[std::size_t(k)]);
    points.emplace_back(int(128 + radius * std::cos(angle)), int(128 + radius * std::sin(angle)));
  }
  cv::Mat mask(256, 256, CV_8U, cv::Scalar(0));
  cv::fillPoly(mask, std::vector<std::vector<cv::Point>>{points}, 255);
  return mask;
}

inline void write_png(const std::string& path, const cv::Mat& image) {
  const std::vector<std::uint8_t> bytes = png_of(image);
  std::ofstream(path, std::ios::binary)
      .write(reinterpret_cast<const char*>(bytes.data()), std::streamsize(bytes.size()));
}

/// Writes blob-0.png, blob-1.png and so on.
inline void write_blobs(const ScratchFolder& folder, int count) {
  for (int i = 0; i < count; ++i) {
    write_png(folder.path("blob-" + std::to_string(i) + ".png"), blob_mask(std::uint64_t(i)));
  }
}

}  // namespace tessera::test
