// Divides an alpha channel into regions in which alpha changes gradually. Between regions are edges, where alpha jumps.
#pragma once

#include <cstddef>
#include <cstdint>
#include <opencv2/core.hpp>
#include <vector>

namespace tessera {

/// Alpha (of 255) from which a pixel is opaque; opaque pixels belong to no region.
inline constexpr int kOpaqueAlpha = 250;
/// Largest width of an edge, in px of the source.
inline constexpr int kEdgeWidth_px = 4;

struct AlphaRegion {
  int pixels = 0;
  int core_pixels = 0;  // those of them in areas wider than a line
  // Alpha of 255, without areas that are lines:
  int least = 255;
  int most = 0;
  double level = 0;      // mean alpha
  double flat_part = 0;  // share of pixels whose alpha differs from the mean by at most 30 % of it
  // The sides of its pixels that lie on its border, counted by what is beyond:
  int fading = 0;            // clear pixels outside the drawing, without an edge between
  int fading_in_holes = 0;   // clear pixels in a hole, without an edge between
  int falling = 0;           // an edge, and lower alpha behind it
  int slightly_falling = 0;  // the same, with a fall of less than RegionRules::least_fall
  int rising = 0;            // an edge, and higher alpha behind it
  int merging = 0;           // opaque pixels, without an edge between
};

struct AlphaRegions {
  cv::Mat label;                     // CV_32S, label of each pixel; 0: no region
  std::vector<AlphaRegion> regions;  // by label; the first one stands for "no region"

  const AlphaRegion& at(int y, int x) const { return regions[std::size_t(label.at<int>(y, x))]; }
};

/// The rules that decide which pixels of an alpha channel form one region. Alpha is 0 to 255.
struct RegionRules {
  int clear_alpha;         // a pixel with less is clear, and belongs to no region
  double least_step;       // smallest range of alpha within 1 px of an edge
  int least_fall;          // a smaller fall is slight: soft shadows may consist of such steps
  bool has_lines = false;  // true: lines are regions, too; false: lines do not divide the regions that they cross
};
inline constexpr RegionRules kPlainRegions{25, 20, 0};
/// More sensitive rules. With them the tail of a shadow may join parts that are separate regions of the plain rules.
inline constexpr RegionRules kFaintRegions{8, 6, 18};
inline constexpr RegionRules kFaintLines{8, 6, 18, true};

/// Finds the regions. `alpha`: CV_8U. `unit_px`: size of a pixel of the source in px of `alpha`, 1 or more.
AlphaRegions alpha_regions(const cv::Mat& alpha, int unit_px, const RegionRules& rules);

}  // namespace tessera
