#include "worker/shard/pair_keypoints.h"

#include <algorithm>

#include "worker/shard/shard.h"

namespace tessera::worker {

PairKeypoints::PairKeypoints(const MatchRecord& match, int pad_levels, const ModelSource& models, bool reads)
    : match_(match),
      pad_levels_(pad_levels),
      models_(&models),
      reads_(reads) {
  if (!reads_) all_.reserve(std::size_t(match.shapes) * match.sources * keypoint_numbers(pad_levels));
}

void PairKeypoints::add(const std::vector<ShapeModel>& models) {
  if (reads_) return;
  for (const ShapeModel& model : models) append_keypoints(all_, model, pad_levels_);
}

std::vector<std::int16_t> PairKeypoints::of(std::span<const PairRecord> pairs) const {
  if (reads_) return read(pairs);
  const std::size_t numbers = keypoint_numbers(pad_levels_);
  std::vector<std::int16_t> result(pairs.size() * numbers);
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    std::copy_n(all_.data() + std::size_t(pairs[i].source) * numbers, numbers, result.data() + i * numbers);
  }
  return result;
}

std::vector<std::int16_t> PairKeypoints::read(std::span<const PairRecord> pairs) const {
  std::vector<ModelSource::PadName> names;
  for (const PairRecord& pair : pairs) {
    names.push_back({ShapeId(match_.first_shape + pair.source / match_.sources), pair.source % match_.sources});
  }
  const std::vector<ModelSample::Step> points = models_->keypoints(names);
  const std::size_t count = keypoint_numbers(pad_levels_) / 2;
  std::vector<std::int16_t> result;
  result.reserve(2 * points.size());
  for (std::size_t first = 0; first < points.size(); first += count) {
    for (std::size_t i = first; i < first + count; ++i) result.push_back(points[i].x);
    for (std::size_t i = first; i < first + count; ++i) result.push_back(points[i].y);
  }
  return result;
}

}  // namespace tessera::worker
