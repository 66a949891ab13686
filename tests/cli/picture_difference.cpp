// picture_difference A.png B.png [RESULT_FOLDER]: prints the mean difference of two pictures of one size, of 255.
// With RESULT_FOLDER it also prints the pieces that differ most, a line each: mean difference, index, shape.
#include <algorithm>
#include <cstdio>
#include <fstream>
#include <nlohmann/json.hpp>
#include <opencv2/imgproc.hpp>
#include <string>
#include <tuple>
#include <vector>

#include "support/images.h"

namespace {

constexpr std::size_t kPiecesShown = 12;

/// Reads a picture and lays it on white.
cv::Mat read_picture(const char* path) {
  const cv::Mat image = tessera::test::read_image(path);
  if (image.channels() != 4) return image;
  cv::Mat bgr(image.size(), CV_8UC3);
  for (int y = 0; y < image.rows; ++y) {
    for (int x = 0; x < image.cols; ++x) {
      const cv::Vec4b c = image.at<cv::Vec4b>(y, x);
      for (int i = 0; i < 3; ++i)
        bgr.at<cv::Vec3b>(y, x)[i] = std::uint8_t((c[i] * c[3] + 255 * (255 - c[3]) + 127) / 255);
    }
  }
  return bgr;
}

double mean_of(const cv::Mat& difference, const cv::Mat& mask = cv::Mat()) {
  const cv::Scalar mean = cv::mean(difference, mask);
  return (mean[0] + mean[1] + mean[2]) / 3;
}

void print_pieces(const cv::Mat& difference, const std::string& folder) {
  const auto pieces = nlohmann::json::parse(std::ifstream(folder + "/pieces.geojson"));
  std::string text(8192, '\0');
  std::ifstream(folder + "/collage.svg").read(text.data(), std::streamsize(text.size()));
  double canvas_px = 0;
  std::sscanf(text.c_str() + text.find("viewBox=\"0 0 "), "viewBox=\"0 0 %lf", &canvas_px);
  const double px = difference.cols / canvas_px;
  std::vector<std::tuple<double, int, std::string>> found;
  for (const auto& piece : pieces["features"]) {
    std::vector<cv::Point> ring;
    for (const auto& p : piece["geometry"]["coordinates"][0]) {
      ring.emplace_back(int(p[0].get<double>() * px), int(p[1].get<double>() * px));
    }
    cv::Mat mask(difference.size(), CV_8U, cv::Scalar(0));
    cv::fillPoly(mask, std::vector{ring}, 255);
    found.emplace_back(mean_of(difference, mask), piece["properties"]["index"], piece["properties"]["shape"]);
  }
  std::sort(found.rbegin(), found.rend());
  for (std::size_t i = 0; i < std::min(found.size(), kPiecesShown); ++i) {
    const auto& [mean, index, shape] = found[i];
    std::printf("  %6.2f  %d %s\n", mean, index, shape.c_str());
  }
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 3) return 2;
  const cv::Mat a = read_picture(argv[1]);
  const cv::Mat b = read_picture(argv[2]);
  if (a.empty() || b.empty() || a.size() != b.size()) {
    std::fprintf(stderr, "%s and %s: not two pictures of one size\n", argv[1], argv[2]);
    return 1;
  }
  cv::Mat difference;
  cv::absdiff(a, b, difference);
  std::printf("%.3f\n", mean_of(difference));
  if (argc > 3) print_pieces(difference, argv[3]);
}
