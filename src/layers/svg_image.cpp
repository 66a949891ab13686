#include "layers/svg_image.h"

#include <algorithm>
#include <opencv2/imgproc.hpp>

#include "artwork/images/png_uri.h"
#include "text/xml_writer.h"

namespace tessera {

cv::Mat in_embedded_size(const cv::Mat& picture) {
  const double scale = double(kMaxBitmapSide_px) / std::max(picture.cols, picture.rows);
  if (scale >= 1) return picture;
  const cv::Size size(std::max(1, cvRound(picture.cols * scale)), std::max(1, cvRound(picture.rows * scale)));
  cv::Mat small;
  cv::resize(picture, small, size, 0, 0, cv::INTER_AREA);
  return small;
}

std::string svg_image(const cv::Mat& bgra, const std::string& id) {
  XmlWriter writer;
  writer.start("image").attribute("id", id);
  writer.attribute("width", std::to_string(bgra.cols)).attribute("height", std::to_string(bgra.rows));
  writer.attribute("preserveAspectRatio", "none").attribute("xlink:href", png_uri(bgra));
  return writer.finish();
}

}  // namespace tessera
