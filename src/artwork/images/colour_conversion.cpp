#include "artwork/images/colour_conversion.h"

#include <array>
#include <cstdint>
#include <cstdio>
#include <opencv2/imgproc.hpp>

namespace tessera {

cv::Mat lab_image_of(const cv::Mat& image) {
  cv::Mat bgr = image, lab;
  if (image.channels() == 4) cv::cvtColor(image, bgr, cv::COLOR_BGRA2BGR);
  bgr.convertTo(bgr, CV_32F, 1.0 / 255);
  cv::cvtColor(bgr, lab, cv::COLOR_BGR2Lab);
  return lab;
}

Lab lab_of(const cv::Vec3d& bgr) {
  const cv::Mat pixel(1, 1, CV_32FC3, cv::Scalar(bgr[0] / 255, bgr[1] / 255, bgr[2] / 255));
  cv::Mat lab;
  cv::cvtColor(pixel, lab, cv::COLOR_BGR2Lab);
  const cv::Vec3f c = lab.at<cv::Vec3f>(0, 0);
  return {c[0], c[1], c[2]};
}

cv::Vec3b bgr_of(const Lab& lab) {
  const cv::Mat pixel(1, 1, CV_32FC3, cv::Scalar(lab.lightness, lab.a, lab.b));
  cv::Mat bgr;
  cv::cvtColor(pixel, bgr, cv::COLOR_Lab2BGR);
  const cv::Vec3f c = bgr.at<cv::Vec3f>(0, 0) * 255;
  return {cv::saturate_cast<std::uint8_t>(c[0]), cv::saturate_cast<std::uint8_t>(c[1]),
          cv::saturate_cast<std::uint8_t>(c[2])};
}

cv::Vec3b bgr_of(const std::string& hex) {
  const unsigned long rgb = std::stoul(hex.substr(1), nullptr, 16);
  return {std::uint8_t(rgb), std::uint8_t(rgb >> 8), std::uint8_t(rgb >> 16)};
}

std::string hex_of(const cv::Vec3b& bgr) {
  std::array<char, 8> text;
  std::snprintf(text.data(), text.size(), "#%02x%02x%02x", unsigned(bgr[2]), unsigned(bgr[1]), unsigned(bgr[0]));
  return text.data();
}

}  // namespace tessera
