#include "render/hue_turns.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <optional>
#include <vector>

#include "artwork/images/colour_conversion.h"
#include "core/geometry/degrees.h"
#include "render/pieces/tones.h"

namespace tessera {
namespace {

// of CIELAB: smaller chroma looks grey, and its hue comes from the rounding of 8 bits
constexpr double kLeastChroma = 2;

/// The hue in CIELAB, degrees from 0.
double hue_of(double a, double b) {
  const double hue_deg = std::atan2(b, a) * kDegreesPerRad;
  return hue_deg < 0 ? hue_deg + kHues : hue_deg;
}

double arc_deg(double from_deg, double to_deg) { return std::abs(std::remainder(to_deg - from_deg, kHues)); }

/// A piece's mean colour as it is drawn without harmony.
cv::Vec3b shifted_colour(const CollageReport& report, std::size_t piece) {
  cv::Vec3b bgr = drawn_colour(report, piece);
  if (report.tones.empty()) return bgr;
  const cv::Vec4d over = report.tones[piece].patch.mean();
  for (int c = 0; c < 3; ++c) bgr[c] = cv::saturate_cast<std::uint8_t>(bgr[c] * (1 - over[3]) + over[c]);
  return bgr;
}

/// The colour `v` (blue, green, red) multiplied by the matrix.
cv::Vec3b turned(const std::array<std::array<double, 3>, 3>& m, const cv::Vec3b& v, int most) {
  cv::Vec3b result;
  for (std::size_t c = 0; c < 3; ++c) {
    const std::array<double, 3>& row = m[2 - c];
    const double sum = row[0] * v[2] + row[1] * v[1] + row[2] * v[0];
    result[int(c)] = std::uint8_t(std::clamp(int(std::lround(sum)), 0, most));
  }
  return result;
}

/// Turns in the order 0, 1, -1, 2, -2 .. 180: the least turn comes first.
int turn_at(int place) { return place % 2 == 1 ? (place + 1) / 2 : -place / 2; }

/// The hues of a colour that is turned by turn_at(0), turn_at(1) and so on. They are not the old hue plus the turn, because
/// hueRotate turns the wheel of red, green and blue.
std::vector<double> hues_turned(const cv::Vec3b& bgr) {
  cv::Mat row(1, kHues, CV_8UC3);
  for (int k = 0; k < kHues; ++k) row.at<cv::Vec3b>(0, k) = turned(hue_rotation(turn_at(k)), bgr, 255);
  const cv::Mat lab = lab_image_of(row);
  std::vector<double> hues;
  for (int k = 0; k < kHues; ++k) hues.push_back(hue_of(lab.at<cv::Vec3f>(0, k)[1], lab.at<cv::Vec3f>(0, k)[2]));
  return hues;
}

/// The turn that brings a colour nearest to the hue.
int turn_to(const cv::Vec3b& bgr, double hue_deg) {
  const std::vector<double> hues = hues_turned(bgr);
  const auto nearest = std::min_element(hues.begin(), hues.end(),
                                        [&](double a, double b) { return arc_deg(a, hue_deg) < arc_deg(b, hue_deg); });
  return turn_at(int(nearest - hues.begin()));
}

struct PieceHue {
  cv::Vec3b bgr;
  std::optional<int> hue_deg;  // empty: grey
  double chroma = 0;
};

PieceHue hue_of_piece(const CollageReport& report, std::size_t piece) {
  PieceHue result{shifted_colour(report, piece), {}, 0};
  const Lab lab = lab_of(cv::Vec3d(result.bgr));
  result.chroma = std::hypot(double(lab.a), double(lab.b));
  if (result.chroma >= kLeastChroma) result.hue_deg = int(std::lround(hue_of(lab.a, lab.b))) % kHues;
  return result;
}

}  // namespace

std::array<std::array<double, 3>, 3> hue_rotation(int turn_deg) {
  const double c = std::cos(turn_deg / kDegreesPerRad), s = std::sin(turn_deg / kDegreesPerRad);
  return {{{0.213 + c * 0.787 - s * 0.213, 0.715 - c * 0.715 - s * 0.715, 0.072 - c * 0.072 + s * 0.928},
           {0.213 - c * 0.213 + s * 0.143, 0.715 + c * 0.285 + s * 0.140, 0.072 - c * 0.072 - s * 0.283},
           {0.213 - c * 0.213 - s * 0.787, 0.715 - c * 0.715 + s * 0.715, 0.072 + c * 0.928 + s * 0.072}}};
}

void turn_hues(cv::Mat& bgra, int turn_deg) {
  if (turn_deg == 0) return;
  const auto rotation = hue_rotation(turn_deg);
  for (int y = 0; y < bgra.rows; ++y) {
    cv::Vec4b* row = bgra.ptr<cv::Vec4b>(y);
    for (int x = 0; x < bgra.cols; ++x) {
      const cv::Vec3b bgr = turned(rotation, {row[x][0], row[x][1], row[x][2]}, row[x][3]);
      row[x] = {bgr[0], bgr[1], bgr[2], row[x][3]};
    }
  }
}

void harmonise(CollageReport& report, const std::string& wanted) {
  if (wanted == kNoHarmony) return;
  std::vector<PieceHue> pieces;
  HueHistogram weights{};
  for (std::size_t i = 0; i < report.placements.size(); ++i) {
    pieces.push_back(hue_of_piece(report, i));
    const double scale_px = report.placements[i].canvas_from_shape.scale();  // its square is the piece's area
    if (pieces[i].hue_deg) weights[std::size_t(*pieces[i].hue_deg)] += scale_px * scale_px * pieces[i].chroma;
  }
  if (std::all_of(weights.begin(), weights.end(), [](double weight) { return weight == 0; })) return;
  const Harmony harmony = wanted == "auto" ? best_harmony(weights) : best_harmony(weights, template_of(wanted));
  report.harmony = harmony;
  if (disharmony(weights, harmony) == 0) return;
  report.tones.resize(pieces.size());
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    if (!pieces[i].hue_deg) continue;
    const double there_deg = harmonised_hue(*pieces[i].hue_deg, harmony);
    if (there_deg != *pieces[i].hue_deg) report.tones[i].turn_deg = turn_to(pieces[i].bgr, there_deg);
  }
}

}  // namespace tessera
