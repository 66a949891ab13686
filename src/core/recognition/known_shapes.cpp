#include "core/recognition/known_shapes.h"

namespace tessera {
namespace {

PadSearch make_search(const std::vector<ShapeModel>& models, std::size_t level, int pad_levels) {
  std::vector<PadBytes> bytes;
  for (const ShapeModel& model : models) {
    for (const ModelSample& sample : model.levels[level].samples) {
      bytes.push_back(pad_bytes(sample.pad, sample.scale_length, sample.convexity));
    }
  }
  return PadSearch(make_pad_index(bytes, 2 * (pad_levels - 1), kRecognitionScaleShare), bytes, pad_levels);
}

}  // namespace

KnownShapes::KnownShapes(ShapeId first, std::vector<ShapeModel> models, std::vector<float> drawn_scales_px,
                         int pad_levels)
    : first_(first),
      models_(std::move(models)),
      drawn_scales_px_(std::move(drawn_scales_px)),
      pad_levels_(pad_levels) {
  if (models_.empty()) return;
  for (std::size_t k = 0; k < models_.front().levels.size(); ++k) {
    const ModelLevel& level = models_.front().levels[k];
    levels_.push_back({level.level, std::uint32_t(level.samples.size()), make_search(models_, k, pad_levels_)});
  }
}

Keypoints KnownShapes::keypoints_of(std::size_t level, std::uint32_t place) const {
  const Level& index = levels_[level];
  const ShapeModel& model = models_[index.shape_of(place)];
  return keypoints(model.levels[level].samples[index.sample_of(place)], keypoint_step(model.radius));
}

}  // namespace tessera
