#include "render/pieces/tones.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "artwork/images/colour_conversion.h"
#include "core/colour/ciede2000.h"
#include "core/geometry/extent.h"
#include "core/matching/colour_fit.h"
#include "render/pieces/sprite.h"

namespace tessera {
namespace {

/// The most opacity of what is laid over a piece: more takes too much of the drawing's own contrast. Measured with 0.15
/// to 0.3 (docs/decisions/2026-11-27-tone-patches.md).
constexpr double kMostOpacity = 0.25;
/// A change of so much (of 255) in colour may use an opacity up to 1, a smaller change proportionally less. Otherwise white
/// that shall become a little whiter would be veiled.
constexpr double kWayOfFullOpacity = 40;
constexpr double kLeastWay = 0.5;  // of 255; a smaller change is rounding
constexpr int kHalvings = 7;       // of the way to the colour beneath
/// Each cell is smoothed with its neighbours, and a little with the whole piece. So cells that are hardly drawn on follow
/// these.
constexpr double kSideShare = 0.25;
constexpr double kWholeShare = 0.02;
constexpr int kSamples = 4;  // samples of the picture along a cell's side

/// Maps cells to canvas px; the grid covers the bounding box of the outline.
cv::Matx23d canvas_from_cells(const Shape& shape, const Similarity& pose) {
  const Extent box = extent_of(shape.outline.curves.front(), {1, 0, 0, 0});
  const double width = double(box.high.x - box.low.x) / kColourSide;
  const double height = double(box.high.y - box.low.y) / kColourSide;
  const Vec2 low = pose.apply(box.low);
  return {pose.a * width, -pose.b * height, low.x, pose.b * width, pose.a * height, low.y};
}

/// False for an outline without area, which a library of unknown origin may hold.
bool has_area(const cv::Matx23d& m) {
  const double area = m(0, 0) * m(1, 1) - m(0, 1) * m(1, 0);
  return std::isfinite(area) && area != 0 && std::isfinite(m(0, 2)) && std::isfinite(m(1, 2));
}

/// The shown picture, over the canvas.
class Shown {
 public:
  Shown(const cv::Mat& bgra, const Canvas& canvas)
      : bgra_(bgra),
        px_x_(double(bgra.cols) / canvas.width_px),
        px_y_(double(bgra.rows) / canvas.height_px) {}

  /// The mean of a cell, BGR; empty where the picture is transparent.
  std::optional<cv::Vec3d> of_cell(const cv::Matx23d& canvas_from_cells, int column, int row) const {
    cv::Vec4d sum;
    for (int j = 0; j < kSamples; ++j) {
      for (int i = 0; i < kSamples; ++i) {
        const double u = column + (i + 0.5) / kSamples, v = row + (j + 0.5) / kSamples;
        sum += at(canvas_from_cells * cv::Vec3d(u, v, 1));
      }
    }
    constexpr double kLeastAlpha = double(kLeastColourWeight) * kSamples * kSamples;
    if (sum[3] < kLeastAlpha) return std::nullopt;
    return cv::Vec3d(sum[0], sum[1], sum[2]) / sum[3];
  }

 private:
  /// The nearest pixel, premultiplied, alpha from 0 to 1.
  cv::Vec4d at(const cv::Vec2d& canvas_px) const {
    const int x = int(std::clamp(canvas_px[0] * px_x_, 0., bgra_.cols - 1.));
    const int y = int(std::clamp(canvas_px[1] * px_y_, 0., bgra_.rows - 1.));
    const cv::Vec4b& pixel = bgra_.at<cv::Vec4b>(y, x);
    const double alpha = pixel[3] / 255.;
    return {pixel[0] * alpha, pixel[1] * alpha, pixel[2] * alpha, alpha};
  }

  const cv::Mat& bgra_;
  double px_x_, px_y_;  // pixels of a canvas px
};

/// The colour of a cell, and its difference from the wished colour. Both are sums that must be divided by `part`.
struct Cell {
  cv::Vec3d own, way;
  double part = 0;

  void add(const Cell& other, double share) {
    own += share * other.own;
    way += share * other.way;
    part += share * other.part;
  }
};

OfCells<Cell> smoothed(const OfCells<Cell>& cells) {
  Cell all;
  for (const Cell& cell : cells) all.add(cell, kWholeShare / kColourCells);
  OfCells<Cell> result{};
  for (int row = 0; row < kColourSide; ++row) {
    for (int column = 0; column < kColourSide; ++column) {
      Cell& cell = result[std::size_t(row * kColourSide + column)];
      cell.add(all, 1);
      for (int y = std::max(row - 1, 0); y <= std::min(row + 1, kColourSide - 1); ++y) {
        for (int x = std::max(column - 1, 0); x <= std::min(column + 1, kColourSide - 1); ++x) {
          const double share = (y == row ? 1 : kSideShare) * (x == column ? 1 : kSideShare);
          cell.add(cells[std::size_t(y * kColourSide + x)], share);
        }
      }
    }
  }
  return result;
}

OfCells<Lab> labs_of(const OfCells<cv::Vec3d>& bgr) {
  cv::Mat row(1, kColourCells, CV_8UC3);
  for (int i = 0; i < kColourCells; ++i) {
    for (int c = 0; c < 3; ++c) row.at<cv::Vec3b>(0, i)[c] = cv::saturate_cast<std::uint8_t>(bgr[std::size_t(i)][c]);
  }
  const cv::Mat labs = lab_image_of(row);
  OfCells<Lab> result;
  for (int i = 0; i < kColourCells; ++i) {
    const cv::Vec3f& lab = labs.at<cv::Vec3f>(0, i);
    result[std::size_t(i)] = {lab[0], lab[1], lab[2]};
  }
  return result;
}

/// Shortens the changes so that no cell's colour changes by more than `most_difference`.
void limit(double most_difference, const OfCells<cv::Vec3d>& own, OfCells<cv::Vec3d>& ways) {
  const OfCells<Lab> before = labs_of(own);
  const auto allowed = [&](const OfCells<double>& parts) {
    OfCells<cv::Vec3d> there;
    for (std::size_t i = 0; i < kColourCells; ++i) there[i] = own[i] + ways[i] * parts[i];
    const OfCells<Lab> after = labs_of(there);
    OfCells<bool> result;
    for (std::size_t i = 0; i < kColourCells; ++i)
      result[i] = double(ciede2000(before[i], after[i])) <= most_difference;
    return result;
  };
  OfCells<double> whole;
  whole.fill(1);
  const OfCells<bool> wholly = allowed(whole);
  OfCells<double> parts{};
  double step = 0.5;
  for (int k = 0; k < kHalvings; ++k, step /= 2) {
    OfCells<double> further = parts;
    for (double& part : further) part += step;
    const OfCells<bool> may = allowed(further);
    for (std::size_t i = 0; i < kColourCells; ++i) {
      if (may[i]) parts[i] = further[i];
    }
  }
  for (std::size_t i = 0; i < kColourCells; ++i) {
    if (!wholly[i]) ways[i] *= parts[i];
  }
}

/// The most transparent colour that changes `own` by `way` when it is laid over it. Its opacity is at most kMostOpacity.
cv::Vec4b overlay(const cv::Vec3d& own, const cv::Vec3d& way) {
  double opacity = 0;
  for (int c = 0; c < 3; ++c) {
    const double room = way[c] > 0 ? 255 - own[c] : own[c];
    if (way[c] != 0) opacity = std::max(opacity, room > 0 ? std::abs(way[c]) / room : 1.);
  }
  const double length = std::max({std::abs(way[0]), std::abs(way[1]), std::abs(way[2])});
  const int alpha = int(std::ceil(255 * std::min({opacity, kMostOpacity, length / kWayOfFullOpacity})));
  if (length < kLeastWay) return {};
  cv::Vec4b bgra;
  for (int c = 0; c < 3; ++c) bgra[c] = cv::saturate_cast<std::uint8_t>(own[c] + way[c] * 255 / alpha);
  bgra[3] = std::uint8_t(alpha);
  return bgra;
}

TonePatch patch_between(const DrawnColours& own, const OfCells<std::optional<cv::Vec3d>>& wished,
                        double most_difference) {
  OfCells<Cell> cells{};
  bool any = false;
  for (std::size_t i = 0; i < kColourCells; ++i) {
    const double part = wished[i] ? own.part[i] : 0;
    if (part > 0) cells[i] = {own.bgr[i] * part, (*wished[i] - own.bgr[i]) * part, part};
    any = any || part > 0;
  }
  TonePatch patch;
  if (!any) return patch;
  OfCells<cv::Vec3d> colours, ways;
  const OfCells<Cell> smooth = smoothed(cells);
  for (std::size_t i = 0; i < kColourCells; ++i) {
    colours[i] = smooth[i].own / smooth[i].part;
    ways[i] = smooth[i].way / smooth[i].part;
  }
  limit(most_difference, colours, ways);
  for (std::size_t i = 0; i < kColourCells; ++i) patch.bgra[i] = overlay(colours[i], ways[i]);
  return patch;
}

/// The colours of a piece, also of a silhouette in a palette.
DrawnColours own_colours(const CollageReport& report, const std::vector<DrawnColours>& of_slots, std::size_t piece) {
  DrawnColours own = of_slots[report.shapes.slot_of(report.placements[piece].shape)];
  if (!report.colours.empty()) own.bgr.fill(cv::Vec3d(bgr_of(report.colours[piece])));
  return own;
}

}  // namespace

std::vector<std::string> covered_colours(const std::vector<Placement>& placements, const PlacedShapes& shapes,
                                         const ColourTarget& target) {
  std::vector<std::string> colours;
  for (const Placement& placement : placements) {
    const Shape& shape = shapes[shapes.slot_of(placement.shape)];
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

std::vector<Tone> tones_towards_picture(const CollageReport& report, const std::vector<DrawnColours>& drawn,
                                        const cv::Mat& shown_bgra, double most_difference) {
  if (most_difference <= 0 || report.covered.empty()) return {};
  std::vector<Tone> tones(report.placements.size());
  const Shown shown(shown_bgra, *report.canvas);
  for (std::size_t i = 0; i < tones.size(); ++i) {
    if (report.covered[i].empty()) continue;
    const Placement& placement = report.placements[i];
    const cv::Matx23d canvas_from_grid = canvas_from_cells(report.shape(placement.shape), placement.canvas_from_shape);
    if (!has_area(canvas_from_grid)) continue;
    OfCells<std::optional<cv::Vec3d>> wished;
    wished.fill(cv::Vec3d(bgr_of(report.covered[i])));
    for (int cell = 0; cell < kColourCells && !shown_bgra.empty(); ++cell) {
      wished[std::size_t(cell)] = shown.of_cell(canvas_from_grid, cell % kColourSide, cell / kColourSide);
    }
    tones[i].patch = patch_between(own_colours(report, drawn, i), wished, most_difference);
    tones[i].patch.canvas_from_cells = canvas_from_grid;
  }
  return tones;
}

}  // namespace tessera
