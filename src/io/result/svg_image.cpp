#include "io/result/svg_image.h"

#include <glib.h>

#include <cstdint>
#include <opencv2/imgcodecs.hpp>
#include <vector>

#include "io/xml_writer.h"

namespace tessera::io {
namespace {

std::string png_uri(const cv::Mat& bgra) {
  std::vector<std::uint8_t> png;
  cv::imencode(".png", bgra, png);
  gchar* base64 = g_base64_encode(png.data(), png.size());
  std::string uri = std::string("data:image/png;base64,") + base64;
  g_free(base64);
  return uri;
}

}  // namespace

std::string svg_image(const cv::Mat& bgra, const std::string& id) {
  XmlWriter writer;
  writer.start("image").attribute("id", id);
  writer.attribute("width", std::to_string(bgra.cols)).attribute("height", std::to_string(bgra.rows));
  writer.attribute("preserveAspectRatio", "none").attribute("xlink:href", png_uri(bgra));
  return writer.finish();
}

}  // namespace tessera::io
