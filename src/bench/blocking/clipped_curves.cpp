#include "bench/blocking/clipped_curves.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

namespace tessera::bench {

std::vector<Curve> clipped_curves(const cv::Mat& mask, const Clipping& clipping, const View& view, Draws& draws) {
  cv::Mat left = mask.clone();
  const cv::Rect whole = cv::boundingRect(left);
  const int edge = std::min(left.cols, int(std::lround(whole.x + clipping.blocked * whole.width)));
  left.colRange(0, edge).setTo(0);
  HiderDistance from_edge;
  if (clipping.blocked > 0 && clipping.edge_removed) from_edge = [edge](Vec2 p) { return double(p.x) - (edge - 0.5); };
  return seen_curves(left, view, from_edge, draws);
}

}  // namespace tessera::bench
