#include "artwork/solid_coverage.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <opencv2/imgproc.hpp>
#include <optional>
#include <vector>

#include "artwork/alpha_regions.h"
#include "artwork/images/page_pixels.h"
#include "artwork/nearest_pixels.h"

namespace tessera {
namespace {

// Alpha values, of 255.
constexpr int kHalf = 128;
constexpr int kBarelyHalf = 153;      // with less, the outline at one half lies inside the edge
constexpr double kLeastLevel = 19.5;  // of a part that counts, and of a pixel in a lost line: opacity 0.08
/// Smallest size of a region. Smaller ones may be crossings of thin lines, where alpha is smooth, too.
constexpr int kLeastPixels = 256;
constexpr double kFlatPart = 0.7;
/// Smallest size of a line or a spot, and the share of flat pixels that it needs.
constexpr int kLeastLinePixels = 48;
/// One kind of border prevails if it is at least this many times as long as the other.
constexpr int kMostly = 2;
/// A region hardly fades anywhere if its edges are this many times as long.
constexpr int kAlmostWholly = 16;

/// The kind of a region whose coverage is not its alpha. A faint region would be solid, but lies below kLeastLevel.
enum class Kind : std::uint8_t { as_opaque, solid, shadow, faint };

bool is_large(const AlphaRegion& region, int unit_px) { return region.core_pixels >= kLeastPixels * unit_px * unit_px; }

int soft_border(const AlphaRegion& region) { return region.fading + region.slightly_falling; }

/// Smallest alpha that counts. Where a region fades, pixels far less opaque than the rest are its fading end.
int least_counted(const AlphaRegion& region) {
  const bool has_edges = region.falling >= kAlmostWholly * (soft_border(region) + region.fading_in_holes);
  return has_edges ? 0 : int(region.level / 2);
}

bool ends_at_edges(const AlphaRegion& region) {
  return region.falling >= kMostly * soft_border(region) &&
         (region.flat_part >= kFlatPart || region.falling >= kMostly * (soft_border(region) + region.fading_in_holes));
}

/// The kind of a region that may be solid, by its border. All edges of a faint region are slight.
Kind kind_by_border(const AlphaRegion& region) {
  if (region.level >= kLeastLevel) return ends_at_edges(region) ? Kind::solid : Kind::as_opaque;
  const int edges = region.falling + region.slightly_falling;
  return edges > 0 && edges >= kMostly * region.fading ? Kind::faint : Kind::as_opaque;
}

/// Whether the region is a shadow: it fades on one side, and on the other ends at edges of something more opaque, or
/// stands alone.
bool is_shadow_of_body(const AlphaRegion& region) {
  return region.fading > kMostly * region.falling && region.rising >= region.merging;
}

/// The kinds of the large regions, by label.
std::vector<Kind> kinds_of(const AlphaRegions& parts, const cv::Mat& alpha, int unit_px) {
  std::vector<Kind> kinds(parts.regions.size(), Kind::as_opaque);
  for (std::size_t i = 1; i < kinds.size(); ++i) {
    const AlphaRegion& region = parts.regions[i];
    if (is_large(region, unit_px)) kinds[i] = kind_by_border(region);
  }
  const bool any_body =
      std::count(kinds.begin(), kinds.end(), Kind::solid) > 0 || cv::countNonZero(alpha >= kOpaqueAlpha) > 0;
  for (std::size_t i = 1; i < kinds.size(); ++i) {
    if (!any_body || kinds[i] != Kind::as_opaque || !is_large(parts.regions[i], unit_px)) continue;
    if (is_shadow_of_body(parts.regions[i])) kinds[i] = Kind::shadow;
  }
  return kinds;
}

/// The kinds of lines and spots, by label. Crossings of thin lines are smooth, too, but not flat.
std::vector<Kind> line_kinds_of(const AlphaRegions& lines, int unit_px) {
  std::vector<Kind> kinds(lines.regions.size(), Kind::as_opaque);
  for (std::size_t i = 1; i < kinds.size(); ++i) {
    const AlphaRegion& region = lines.regions[i];
    const bool is_flat = region.flat_part >= kFlatPart && region.pixels >= kLeastLinePixels * unit_px * unit_px;
    const bool stands_out = region.falling > 0 && region.falling >= kMostly * region.merging;
    if (is_flat && stands_out) kinds[i] = kind_by_border(region);
  }
  return kinds;
}

/// Whether the region's outline differs from that of alpha.
bool matters(const AlphaRegion& region, Kind kind) {
  if (kind == Kind::solid) return std::max(region.least, least_counted(region)) < kBarelyHalf;
  return kind == Kind::shadow && region.most >= kHalf;
}

/// The regions of an alpha channel with their kinds.
class RegionKinds {
 public:
  RegionKinds(const cv::Mat& alpha, int unit_px)
      : unit_px_(unit_px),
        plain_(alpha_regions(alpha, unit_px, kPlainRegions)),
        plain_kinds_(kinds_of(plain_, alpha, unit_px)),
        faint_(alpha_regions(alpha, unit_px, kFaintRegions)),
        faint_kinds_(kinds_of(faint_, alpha, unit_px)),
        lines_(alpha_regions(alpha, unit_px, kFaintLines)),
        line_kinds_(line_kinds_of(lines_, unit_px)) {}

  struct Judged {
    const AlphaRegion& region;
    Kind kind;
  };
  /// The judgement for a pixel. The faint regions add only those that end at edges; where there is no large region
  /// there may be a line or a spot.
  Judged at(int y, int x) const {
    const Judged faint = judged(faint_, faint_kinds_, y, x), plain = judged(plain_, plain_kinds_, y, x);
    if (faint.kind == Kind::solid || (faint.kind == Kind::faint && plain.kind == Kind::as_opaque)) return faint;
    return is_large(plain.region, unit_px_) ? plain : judged(lines_, line_kinds_, y, x);
  }

  bool is_edge(int y, int x) const { return plain_.label.at<int>(y, x) == 0; }

 private:
  static Judged judged(const AlphaRegions& regions, const std::vector<Kind>& kinds, int y, int x) {
    return {regions.at(y, x), kinds[std::size_t(regions.label.at<int>(y, x))]};
  }

  int unit_px_;
  AlphaRegions plain_;
  std::vector<Kind> plain_kinds_;
  AlphaRegions faint_;
  std::vector<Kind> faint_kinds_;
  AlphaRegions lines_;
  std::vector<Kind> line_kinds_;
};

/// Masks, CV_8U: opaque pixels; translucent ones that count; those left out as clear or as a shadow; and those left out
/// although they end at an edge.
struct PixelMasks {
  cv::Mat opaque;
  cv::Mat translucent;
  cv::Mat left_out;
  cv::Mat faint;
  cv::Mat fading;            // in regions that fade and are no shadows
  bool any_matters = false;  // see matters()
};

PixelMasks sure_pixels(const cv::Mat& alpha, const RegionKinds& regions) {
  const auto none = [&] { return cv::Mat(cv::Mat::zeros(alpha.size(), CV_8U)); };
  PixelMasks sure{alpha >= kOpaqueAlpha, none(), alpha < kPlainRegions.clear_alpha, none(), none()};
  for (int y = 0; y < alpha.rows; ++y) {
    for (int x = 0; x < alpha.cols; ++x) {
      const auto [region, kind] = regions.at(y, x);
      sure.any_matters = sure.any_matters || matters(region, kind);
      const bool counts = kind == Kind::solid && alpha.at<std::uint8_t>(y, x) >= least_counted(region);
      if (counts) sure.translucent.at<std::uint8_t>(y, x) = 255;
      if (kind == Kind::shadow) sure.left_out.at<std::uint8_t>(y, x) = 255;
      if (kind == Kind::faint) sure.faint.at<std::uint8_t>(y, x) = 255;
      const bool fades = kind == Kind::solid ? !counts : kind == Kind::as_opaque && !regions.is_edge(y, x);
      if (fades) sure.fading.at<std::uint8_t>(y, x) = 255;
    }
  }
  return sure;
}

/// The coverage. On edges it rises like alpha, from what is left out on one side to what counts on the other.
cv::Mat coverage_of(const cv::Mat& alpha, const RegionKinds& regions, const PixelMasks& sure, int unit_px) {
  const NearestPixels opaque(sure.opaque), translucent(sure.translucent), left_out(sure.left_out);
  const auto level = [&](const NearestPixels& pixels, cv::Point at) {
    const std::optional<cv::Point> nearest = pixels.nearest(at);
    return nearest ? int(alpha.at<std::uint8_t>(*nearest)) : 0;
  };
  const double reach_px = kEdgeWidth_px * unit_px;
  cv::Mat coverage = alpha.clone();
  for (int y = 0; y < alpha.rows; ++y) {
    for (int x = 0; x < alpha.cols; ++x) {
      if (!regions.is_edge(y, x)) continue;
      // Where both are near the lower level is used: between a wing and its body nothing is left out.
      const cv::Point at(x, y);
      const double to_translucent_px = double(translucent.distance_px(at)),
                   to_opaque_px = double(opaque.distance_px(at));
      const bool by_wing = to_translucent_px <= std::min(reach_px, to_opaque_px + 2 * unit_px);
      const bool by_shadow =
          double(left_out.distance_px(at)) <= reach_px && level(left_out, at) >= kPlainRegions.clear_alpha;
      if (!by_wing && (!by_shadow || to_opaque_px > reach_px)) continue;
      const int top = level(by_wing ? translucent : opaque, at);
      const int bottom = by_shadow ? std::min(level(left_out, at), top - 1) : 0;
      const double part = double(alpha.at<std::uint8_t>(y, x) - bottom) / (top - bottom);
      coverage.at<std::uint8_t>(y, x) = cv::saturate_cast<std::uint8_t>(255 * part);
    }
  }
  coverage.setTo(255, sure.opaque | sure.translucent);
  coverage.setTo(0, sure.left_out & (alpha >= kPlainRegions.clear_alpha));
  return coverage;
}

/// Removes translucent parts that touch no opaque part, unless there is no opaque part. Returns their number.
int remove_loose_parts(cv::Mat& coverage, const cv::Mat& alpha) {
  cv::Mat label;
  const int count = cv::connectedComponents(coverage >= kHalf, label, 8, CV_32S);
  std::vector<bool> is_loose(std::size_t(count), true);
  is_loose[0] = false;
  for (int y = 0; y < label.rows; ++y) {
    for (int x = 0; x < label.cols; ++x) {
      if (alpha.at<std::uint8_t>(y, x) >= kHalf) is_loose[std::size_t(label.at<int>(y, x))] = false;
    }
  }
  const int loose = int(std::count(is_loose.begin(), is_loose.end(), true));
  if (loose == count - 1) return 0;
  for (int y = 0; y < label.rows; ++y) {
    for (int x = 0; x < label.cols; ++x) {
      if (is_loose[std::size_t(label.at<int>(y, x))]) coverage.at<std::uint8_t>(y, x) = 0;
    }
  }
  return loose;
}

/// Whether a visible part is neither covered nor soft.
bool loses_parts(const cv::Mat& alpha, const cv::Mat& coverage, const PixelMasks& sure, int unit_px) {
  cv::Mat told;
  const cv::Mat shadow = sure.left_out & (alpha >= kPlainRegions.clear_alpha);
  cv::dilate((coverage >= kHalf) | sure.fading | shadow, told, square(kEdgeWidth_px * unit_px));
  const cv::Mat line = (alpha >= kLeastLevel) & ~told;
  return cv::countNonZero(sure.faint | line) >= kLeastPixels * unit_px * unit_px;
}

}  // namespace

SolidCoverage solid_coverage(const cv::Mat& alpha, double source_px) {
  const int unit_px = std::max(1, int(std::lround(source_px)));
  const RegionKinds regions(alpha, unit_px);
  const PixelMasks sure = sure_pixels(alpha, regions);
  SolidCoverage solid{sure.any_matters ? coverage_of(alpha, regions, sure, unit_px) : alpha};
  solid.loses_parts = loses_parts(alpha, solid.coverage, sure, unit_px);
  if (sure.any_matters) solid.loose_parts = remove_loose_parts(solid.coverage, alpha);
  return solid;
}

}  // namespace tessera
