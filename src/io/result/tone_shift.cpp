#include "io/result/tone_shift.h"

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <opencv2/imgproc.hpp>

#include "core/colour/ciede2000.h"
#include "core/geometry/extent.h"
#include "core/matching/colour_fit.h"
#include "io/result/sprite.h"

namespace tessera::io {
namespace {

constexpr int kStep = 4;       // of 255: pieces of one shift share a filter in the SVG
constexpr int kHalvings = 12;  // of the way to the colour beneath

cv::Vec3b bgr_of(const Lab& lab) {
  const cv::Mat pixel(1, 1, CV_32FC3, cv::Scalar(lab.lightness, lab.a, lab.b));
  cv::Mat bgr;
  cv::cvtColor(pixel, bgr, cv::COLOR_Lab2BGR);
  const cv::Vec3f c = bgr.at<cv::Vec3f>(0, 0) * 255;
  return {cv::saturate_cast<std::uint8_t>(c[0]), cv::saturate_cast<std::uint8_t>(c[1]),
          cv::saturate_cast<std::uint8_t>(c[2])};
}

Lab lab_of(const cv::Vec3d& bgr) {
  const cv::Mat pixel(1, 1, CV_32FC3, cv::Scalar(bgr[0] / 255, bgr[1] / 255, bgr[2] / 255));
  cv::Mat lab;
  cv::cvtColor(pixel, lab, cv::COLOR_BGR2Lab);
  const cv::Vec3f c = lab.at<cv::Vec3f>(0, 0);
  return {c[0], c[1], c[2]};
}

std::string hex_of(const cv::Vec3b& bgr) {
  char text[8];
  std::snprintf(text, sizeof text, "#%02x%02x%02x", unsigned(bgr[2]), unsigned(bgr[1]), unsigned(bgr[0]));
  return text;
}

cv::Vec3d bgr_of_hex(const std::string& hex) {
  const long value = std::strtol(hex.c_str() + 1, nullptr, 16);
  return {double(value & 255), double((value >> 8) & 255), double((value >> 16) & 255)};
}

int in_steps(double value) { return kStep * int(std::lround(value / kStep)); }

ToneShift shift_between(const cv::Vec3d& own, const cv::Vec3d& wanted, double most_difference) {
  double part = 1;
  const Lab before = lab_of(own);
  if (double(ciede2000(before, lab_of(wanted))) > most_difference) {
    part = 0;
    double step = 0.5;
    for (int k = 0; k < kHalvings; ++k, step /= 2) {
      const cv::Vec3d there = own + (wanted - own) * (part + step);
      if (double(ciede2000(before, lab_of(there))) <= most_difference) part += step;
    }
  }
  const cv::Vec3d way = (wanted - own) * part;
  return {in_steps(way[2]), in_steps(way[1]), in_steps(way[0])};
}

}  // namespace

std::vector<std::string> covered_colours(const CollageReport& report, const ColourTarget& target) {
  std::vector<std::string> colours;
  for (const Placement& placement : report.placements) {
    const Shape& shape = report.shape(placement.shape);
    const Extent box = extent_of(shape.outline.curves.front(), {1, 0, 0, 0});
    const ColourModel model = make_colour_model(shape.colour_grid, box.low, box.high);
    const auto covered = covered_colour(model, placement.canvas_from_shape, target);
    colours.push_back(covered ? hex_of(bgr_of(*covered)) : "");
  }
  return colours;
}

std::vector<ToneShift> tone_shifts(const CollageReport& report, const std::vector<std::string>& covered,
                                   double most_difference) {
  std::vector<ToneShift> shifts;
  if (most_difference <= 0) return shifts;
  for (std::size_t i = 0; i < covered.size(); ++i) {
    const cv::Vec3b own = mean_bgr(report.shape(report.placements[i].shape));
    shifts.push_back(covered[i].empty() ? ToneShift{}
                                        : shift_between({double(own[0]), double(own[1]), double(own[2])},
                                                        bgr_of_hex(covered[i]), most_difference));
  }
  return shifts;
}

}  // namespace tessera::io
