#include "core/recognition/known_shapes.h"

#include <optional>

#include "core/base/rank_pool.h"

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
  const std::vector<ModelLevel>& levels = models_.front().levels;
  std::vector<std::optional<PadSearch>> searches(levels.size());
  run_both([&] { arcs_.emplace(models_, drawn_scales_px_, pad_levels_); },
           [&] {
             parallel_for(levels.size(),
                          [&](std::size_t k) { searches[k].emplace(make_search(models_, k, pad_levels_)); });
           });
  for (std::size_t k = 0; k < levels.size(); ++k) {
    levels_.push_back({levels[k].level, std::uint32_t(levels[k].samples.size()), std::move(*searches[k])});
  }
}

Keypoints KnownShapes::keypoints_of(std::size_t level, std::uint32_t place) const {
  const Level& index = levels_[level];
  const ShapeModel& model = models_[index.shape_of(place)];
  return keypoints(model.levels[level].samples[index.sample_of(place)], keypoint_step(model.radius));
}

}  // namespace tessera
