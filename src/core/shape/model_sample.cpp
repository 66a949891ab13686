#include "core/shape/model_sample.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace tessera {
namespace {

/// The level whose interval estimates scale and rotation.
int chord_level(int levels) { return std::min(kChordLevel, levels - 1); }

std::int16_t to_step(float length, float step) {
  return std::int16_t(std::lround(std::clamp(length / step, -32767.f, 32767.f)));
}

}  // namespace

float scale_length(const ArclengthPyramid& pyramid, int levels) {
  const int k = chord_level(levels);
  return pyramid.left[k] + pyramid.right[k];
}

float library_length(float length) {
  return std::bit_cast<float>((std::bit_cast<std::uint32_t>(length) + 0x8000u) & 0xffff0000u);
}

Vec2 chord(const ArclengthPyramid& pyramid, int levels) {
  const int k = chord_level(levels);
  return pyramid.keypoint[levels + 1 + k] - pyramid.keypoint[levels - 1 - k];
}

Vec2 chord(const ModelSample& sample, int levels) {
  const int k = chord_level(levels);
  const ModelSample::Step first = sample.keypoint[levels - 1 - k];
  const ModelSample::Step last = sample.keypoint[levels + 1 + k];
  return {float(last.x) - float(first.x), float(last.y) - float(first.y)};
}

ModelSample make_model_sample(const ArclengthPyramid& pyramid, int levels, float keypoint_step) {
  ModelSample sample;
  sample.pad = library_pad(quantised(make_pad(pyramid, levels)));
  sample.scale_length = library_length(scale_length(pyramid, levels));
  sample.convexity = pyramid.convexity;
  for (int i = 0; i < 2 * levels + 1; ++i) {
    sample.keypoint[i] = {to_step(pyramid.keypoint[i].x, keypoint_step), to_step(pyramid.keypoint[i].y, keypoint_step)};
  }
  return sample;
}

Keypoints keypoints(const ModelSample& sample, float keypoint_step) {
  Keypoints result;
  for (std::size_t i = 0; i < result.size(); ++i) {
    result[i] = {float(sample.keypoint[i].x) * keypoint_step, float(sample.keypoint[i].y) * keypoint_step};
  }
  return result;
}

}  // namespace tessera
