#include "layers/svg_image.h"

#include "artwork/images/png_uri.h"
#include "text/xml_writer.h"

namespace tessera {

std::string svg_image(const cv::Mat& bgra, const std::string& id) {
  XmlWriter writer;
  writer.start("image").attribute("id", id);
  writer.attribute("width", std::to_string(bgra.cols)).attribute("height", std::to_string(bgra.rows));
  writer.attribute("preserveAspectRatio", "none").attribute("xlink:href", png_uri(bgra));
  return writer.finish();
}

}  // namespace tessera
