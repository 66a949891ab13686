#include "core/shape/model_sample.h"

#include <algorithm>
#include <cmath>

#include "core/tuning.h"

namespace tessera {
namespace {

std::int16_t to_step(float length, float step) {
  return std::int16_t(std::lround(std::clamp(length / step, -32767.f, 32767.f)));
}

}  // namespace

float scale_length(const ArclengthPyramid& pyramid, int levels) {
  const int k = std::min(kChordLevel, levels - 1);
  return pyramid.left[k] + pyramid.right[k];
}

ModelSample make_model_sample(const ArclengthPyramid& pyramid, int levels, float keypoint_step) {
  ModelSample sample;
  sample.pad = quantised(make_pad(pyramid, levels));
  sample.scale_length = scale_length(pyramid, levels);
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
