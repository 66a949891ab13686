#include "core/quality/size_balance.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace tessera {
namespace {

constexpr int kSizeParts = 5;
constexpr double kDwarfs = 1. / 6;        // of the range
constexpr double kNarrowestRange = 1.01;  // ratio of the largest to the smallest size

}  // namespace

SizeRange size_range_of(const std::vector<JudgedPiece>& pieces) {
  if (pieces.empty()) return {};
  const auto smaller = [](const JudgedPiece& a, const JudgedPiece& b) { return a.scale_px < b.scale_px; };
  const auto [least, most] = std::minmax_element(pieces.begin(), pieces.end(), smaller);
  return {least->scale_px, most->scale_px};
}

double dwarfs_below_px(const SizeRange& range) { return range.min_px * std::pow(range.max_px / range.min_px, kDwarfs); }

std::optional<SizeBalance> size_balance(const std::vector<JudgedPiece>& pieces, const SizeRange& range) {
  if (pieces.empty() || range.min_px <= 0 || range.max_px < kNarrowestRange * range.min_px) return {};
  const double width = std::log(range.max_px / range.min_px);
  if (!std::isfinite(width)) return {};
  std::array<double, kSizeParts> area_px2{};
  double all_px2 = 0;
  double dwarfs_px2 = 0;
  for (const JudgedPiece& piece : pieces) {
    const double px2 = piece.scale_px * piece.scale_px;
    const double at = std::log(piece.scale_px / range.min_px) / width;
    area_px2[std::size_t(std::clamp(at * kSizeParts, 0., kSizeParts - 1.))] += px2;
    if (at < kDwarfs) dwarfs_px2 += px2;
    all_px2 += px2;
  }
  double entropy = 0;
  for (const double px2 : area_px2) {
    if (px2 > 0) entropy -= px2 / all_px2 * std::log(px2 / all_px2);
  }
  return SizeBalance{entropy / std::log(double(kSizeParts)), dwarfs_px2 / all_px2};
}

}  // namespace tessera
