// Small artworks in memory, and their areas, for tests that read artwork.
#pragma once

#include <cstdint>
#include <opencv2/imgproc.hpp>
#include <string>
#include <vector>

#include "artwork/silhouette.h"
#include "support/images.h"

namespace tessera::test {

/// The reason that is reported for a drawing that makes librsvg panic. Under the address sanitizer a panic aborts the process before the
/// drawer can end it in its own way.
#ifdef __SANITIZE_ADDRESS__
inline constexpr const char* kPanicReason = "crashed its process (Aborted)";
#else
inline constexpr const char* kPanicReason = "its process gave up";
#endif

inline Bytes svg(const std::string& body,
                 const std::string& attributes = R"(width="100" height="50" viewBox="0 0 100 50")") {
  const std::string text = R"(<svg xmlns="http://www.w3.org/2000/svg" xmlns:xlink="http://www.w3.org/1999/xlink" )" +
                           attributes + ">" + body + "</svg>";
  return Bytes(text.begin(), text.end());
}

/// A red disc of radius 60 about (150, 100) on 300 x 200.
inline cv::Mat disc_with_alpha() {
  cv::Mat image(200, 300, CV_8UC4, cv::Scalar::all(0));
  cv::circle(image, {150, 100}, 60, cv::Scalar(0, 0, 255, 255), cv::FILLED);
  return image;
}

inline double area_px2(const Silhouette& s) {
  double sum = 0;
  for (const float a : s.alpha.data()) sum += a;
  return sum;
}

/// The silhouette's share of the whole page.
inline double area_fraction(const Silhouette& s) { return area_px2(s) / (double(s.width_px) * s.height_px); }

inline const std::string kDisc = R"(<circle cx="30" cy="25" r="20" fill="#ff0000"/>)";

}  // namespace tessera::test
