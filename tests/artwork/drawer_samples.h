// Settings and messages of drawing processes, for their tests.
#pragma once

#include <opencv2/core.hpp>
#include <string>

#include "artwork/drawers/drawers.h"
#include "core/base/error.h"
#include "support/artwork_samples.h"

namespace tessera::test {

inline const DrawerSettings kTwo{
    .processes = 2, .seconds_per_drawing = 20, .bytes_per_process = std::size_t(256) << 20};

inline std::string mistake(Drawers& drawers, const Bytes& bytes, int side_px = 300) {
  try {
    drawers.render(bytes, "some/file.svg", side_px);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no mistake found";
}

inline bool equal(const cv::Mat& a, const cv::Mat& b) {
  return a.size() == b.size() && a.type() == b.type() && cv::norm(a, b, cv::NORM_INF) == 0;
}

}  // namespace tessera::test
