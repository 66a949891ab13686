#include "artwork/images/png_uri.h"

#include <glib.h>

#include <cstdint>
#include <opencv2/imgcodecs.hpp>
#include <vector>

namespace tessera {

std::string png_uri(const cv::Mat& bgra) {
  std::vector<std::uint8_t> png;
  cv::imencode(".png", bgra, png);
  gchar* base64 = g_base64_encode(png.data(), png.size());
  std::string uri = std::string("data:image/png;base64,") + base64;
  g_free(base64);
  return uri;
}

}  // namespace tessera
