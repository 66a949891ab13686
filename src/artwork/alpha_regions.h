// The parts of an alpha channel: regions in which it changes little by little. Between them are edges, where it jumps.
#pragma once

#include <cstddef>
#include <cstdint>
#include <opencv2/core.hpp>
#include <vector>

namespace tessera {

/// Alpha, of 255: from this on a pixel is opaque, and belongs to no region.
inline constexpr int kOpaqueAlpha = 250;
/// So wide an edge is at most, in px of the source.
inline constexpr int kEdgeWidth_px = 4;

struct AlphaRegion {
  int pixels = 0;
  int core_pixels = 0;  // of them, where it is wider than a line
  // Alpha, of 255, but for lines:
  int least = 255;
  int most = 0;
  double level = 0;      // the mean
  double flat_part = 0;  // of its pixels: no further from the level than 30 % of it
  // How many of its pixels' sides lie on its border, by what is beyond:
  int fading = 0;            // clear outside, without an edge between
  int fading_in_holes = 0;   // the same where the clear pixels lie in a hole
  int falling = 0;           // an edge, and less alpha behind it
  int slightly_falling = 0;  // the same, where alpha falls by less than RegionRules::least_fall
  int rising = 0;            // an edge, and more alpha behind it
  int merging = 0;           // opaque, without an edge between
};

struct AlphaRegions {
  cv::Mat label;                     // CV_32S, of each pixel; 0: in no region
  std::vector<AlphaRegion> regions;  // by label; the first one stands for no region

  const AlphaRegion& at(int y, int x) const { return regions[std::size_t(label.at<int>(y, x))]; }
};

/// The rules by which pixels of an alpha channel make one region. Values of alpha are 0 to 255.
struct RegionRules {
  int clear_alpha;         // below, a pixel is clear, and belongs to no region
  double least_step;       // the range of alpha within 1 px of an edge is this at least
  int least_fall;          // a fall of alpha by less is slight: soft shadows may be made of such steps
  bool has_lines = false;  // areas no wider than a line are regions, too; if not, they part no region that they cross
};
inline constexpr RegionRules kPlainRegions{25, 20, 0};
/// So sensitive, the tail of a shadow may join parts that are regions of their own among the plain ones.
inline constexpr RegionRules kFaintRegions{8, 6, 18};
inline constexpr RegionRules kFaintLines{8, 6, 18, true};

/// `alpha`: CV_8U. `unit_px`: size of a pixel of the source, 1 or more.
AlphaRegions alpha_regions(const cv::Mat& alpha, int unit_px, const RegionRules& rules);

}  // namespace tessera
