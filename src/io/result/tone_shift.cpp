#include "io/result/tone_shift.h"

#include <cmath>

#include "core/colour/ciede2000.h"
#include "core/geometry/extent.h"
#include "core/matching/colour_fit.h"
#include "io/artwork/colour_conversion.h"
#include "io/result/sprite.h"

namespace tessera::io {
namespace {

constexpr int kStep = 4;       // of 255: pieces of one shift share a filter in the SVG
constexpr int kHalvings = 12;  // of the way to the colour beneath

/// Towards zero: no shift is larger than wished for.
int in_steps(double value) { return kStep * int(value / kStep); }

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

cv::Vec3b drawn_colour(const CollageReport& report, std::size_t piece) {
  if (!report.colours.empty()) return bgr_of(report.colours[piece]);
  return mean_bgr(report.shape(report.placements[piece].shape));
}

std::vector<ToneShift> tone_shifts(const CollageReport& report, double most_difference) {
  const std::vector<std::string>& covered = report.covered;
  std::vector<ToneShift> shifts;
  if (most_difference <= 0) return shifts;
  for (std::size_t i = 0; i < covered.size(); ++i) {
    const cv::Vec3b own = drawn_colour(report, i);
    shifts.push_back(covered[i].empty() ? ToneShift{}
                                        : shift_between({double(own[0]), double(own[1]), double(own[2])},
                                                        bgr_of(covered[i]), most_difference));
  }
  return shifts;
}

}  // namespace tessera::io
