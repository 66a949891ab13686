// For tests of collage.svg: a collage with artwork, and ways to look at the written file.
#pragma once

#include <opencv2/imgproc.hpp>
#include <span>
#include <string>

#include "artwork/artwork_render.h"
#include "drawn_collage.h"
#include "sample_collage.h"

namespace tessera::test {

/// The picture that librsvg draws of the SVG. It must have no transparent parts.
inline cv::Mat drawn(const std::string& svg, int width_px) {
  const std::span bytes(reinterpret_cast<const std::uint8_t*>(svg.data()), svg.size());
  cv::Mat bgr;
  cv::cvtColor(render_artwork(bytes, "collage.svg", width_px), bgr, cv::COLOR_BGRA2BGR);
  return bgr;
}

inline double mean_difference(const cv::Mat& a, const cv::Mat& b) {
  cv::Mat difference;
  cv::absdiff(a, b, difference);
  const cv::Scalar mean = cv::mean(difference);
  return (mean[0] + mean[1] + mean[2]) / 3;
}

inline std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
  return found;
}

inline std::string face(const std::string& colour, const std::string& head) {
  return head + R"~(<style>.a{fill:)~" + colour + R"~(}</style><defs><linearGradient id="g"><stop stop-color=")~" +
         colour + R"~("/><stop offset="1" stop-color="white"/></linearGradient></defs>)~" +
         R"~(<circle class="a" cx="40" cy="30" r="28"/>)~" +
         R"~(<rect x="30" y="20" width="20" height="10" fill="url(#g)"/></svg>)~";
}

inline constexpr char kXmlns[] = R"~(<svg xmlns="http://www.w3.org/2000/svg" )~";

struct TwoFaces : SampleCollage {
  TwoFaces() {
    // Both drawings use the same ids and classes. One page is in mm with a view box, the other in px without one.
    const std::string in_mm = std::string(kXmlns) + R"~(width="160mm" height="120mm" viewBox="0 0 80 60">)~";
    const std::string in_px = std::string(kXmlns) + R"~(width="80" height="60">)~";
    embed_artwork(report.shapes[0], face("red", in_mm), 80, 60, 50);
    embed_artwork(report.shapes[1], face("blue", in_px), 80, 60, 50);
    place(ShapeId{7}, 30, {100, 20}, 1.2f);
    place(ShapeId{7}, 25, {100, 80}, -2.f);
  }
};

}  // namespace tessera::test
