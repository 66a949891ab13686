#include "artwork/images/reduced_picture.h"

#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <opencv2/imgproc.hpp>

#include "artwork/images/alpha.h"

namespace tessera {
namespace {

constexpr int kParts = 8;      // of a px: the factor is a whole number of these
constexpr int kBandRows = 64;  // rows of the result; a multiple of kParts

/// The factor: source px for each px of the result, in parts of 1 / kParts.
int factor_in_parts(const cv::Mat& picture, double most_pixels) {
  return int(std::ceil(kParts * std::sqrt(double(picture.total()) / most_pixels)));
}

cv::Mat band_reduced(const cv::Mat& band, cv::Size size) {
  cv::Mat small;
  if (band.channels() != 4) {
    cv::resize(band, small, size, 0, 0, cv::INTER_AREA);
    return small;
  }
  cv::resize(premultiplied(band), small, size, 0, 0, cv::INTER_AREA);
  straighten(small);
  return small;
}

cv::Mat with_8_bits(const cv::Mat& decoded) {
  if (decoded.depth() != CV_16U) return decoded;
  cv::Mat result;
  decoded.convertTo(result, CV_8U, 1.0 / 257);
  return result;
}

/// Gives the memory of rows back to the system; they read as zeros from now on.
void give_back(const cv::Mat& rows) {
  const auto page = std::uintptr_t(::sysconf(_SC_PAGESIZE));
  const std::uintptr_t begin = (std::uintptr_t(rows.data) + page - 1) / page * page;
  const std::uintptr_t end =
      std::uintptr_t(rows.ptr(rows.rows - 1) + std::size_t(rows.cols) * rows.elemSize()) / page * page;
  if (rows.isContinuous() && begin < end) ::madvise(reinterpret_cast<void*>(begin), end - begin, MADV_DONTNEED);
}

}  // namespace

cv::Mat reduced_picture(const cv::Mat& decoded, double most_pixels) {
  const int parts = std::max(kParts, factor_in_parts(decoded, most_pixels));
  if (parts == kParts && decoded.depth() == CV_8U) return decoded;
  const auto reduced = [&](int side) { return std::max(1, int(std::lround(double(side) * kParts / parts))); };
  cv::Mat result(reduced(decoded.rows), reduced(decoded.cols), CV_8UC(decoded.channels()));
  // A band begins on a whole row of the source; the last band takes the rest.
  const int source_rows = kBandRows / kParts * parts;
  for (int top = 0; top < result.rows; top += kBandRows) {
    const int source_top = top / kBandRows * source_rows;
    const bool last = top + kBandRows >= result.rows;
    const cv::Range from(source_top, last ? decoded.rows : source_top + source_rows);
    const cv::Range to(top, std::min(result.rows, top + kBandRows));
    const cv::Mat band = with_8_bits(decoded.rowRange(from));
    (parts == kParts ? band : band_reduced(band, {result.cols, to.size()})).copyTo(result.rowRange(to));
    give_back(decoded.rowRange(from));
  }
  return result;
}

}  // namespace tessera
