// Turns pyramids of the core into the package's PADs.
#pragma once

#include "core/recognition/partial_pyramid.h"
#include "tessera/matching/pad.h"

namespace tessera::matching {

/// The PAD without its place on the curve. `own_from_pyramid`: the frame of the PAD's lengths and position.
inline Pad own_pad(const PartialPyramid& partial, int levels, const Similarity& own_from_pyramid) {
  const ArclengthPyramid& pyramid = partial.pyramid;
  const double scale = own_from_pyramid.scale();
  const Vec2 centre = pyramid.keypoint[std::size_t(levels)];
  Pad pad;
  pad.position = own_from_pyramid.apply({centre.x, centre.y});
  for (int i = 0; i < partial.left_levels; ++i) pad.left.push_back(scale * double(pyramid.left[std::size_t(i)]));
  for (int i = 0; i < partial.right_levels; ++i) pad.right.push_back(scale * double(pyramid.right[std::size_t(i)]));
  pad.convexity = int(pyramid.convexity);
  return pad;
}

}  // namespace tessera::matching
