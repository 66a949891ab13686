#include "artwork/images/png_uri.h"

#include <glib.h>

#include <cstdint>
#include <vector>

#include "artwork/images/png_encoder.h"

namespace tessera {

std::string png_uri(const cv::Mat& bgra) {
  const std::vector<std::uint8_t> png = png_of(bgra);
  gchar* base64 = g_base64_encode(png.data(), png.size());
  std::string uri = std::string("data:image/png;base64,") + base64;
  g_free(base64);
  return uri;
}

}  // namespace tessera
