#include "core/recognition/known_arcs.h"

#include <cmath>

#include "core/base/rank_pool.h"

namespace tessera {
namespace {

/// The outer boundary at even arclength: the places of the finest level's samples.
class Boundary {
 public:
  Boundary(const ShapeModel& model, int pad_levels)
      : samples_(model.levels.back().samples),
        step_(keypoint_step(model.radius)),
        own_(std::size_t(pad_levels)) {}

  std::size_t size() const { return samples_.size(); }
  Vec2 point(std::size_t i) const {
    const ModelSample::Step& step = samples_[i % samples_.size()].keypoint[own_];
    return {float(step.x) * step_, float(step.y) * step_};
  }
  float length() const {
    float length = 0;
    for (std::size_t i = 0; i < size(); ++i) length += norm(point(i + 1) - point(i));
    return length;
  }
  /// The arc that begins at sample `start` and is the fraction `share` of the boundary.
  ArcPoints arc(std::uint32_t start, float share) const {
    ArcPoints points;
    for (int i = 0; i < kArcPoints; ++i) {
      const float along = float(start) + share * float(size()) * float(i) / (kArcPoints - 1);
      const auto before = std::size_t(along);
      const float part = along - float(before);
      points[std::size_t(i)] = point(before) * (1 - part) + point(before + 1) * part;
    }
    return points;
  }

 private:
  const std::vector<ModelSample>& samples_;
  float step_;
  std::size_t own_;  // index of the key point that is the sample's own place
};

/// The length of a boundary's shortest arc: a power of kArcStep in px of the drawing.
float shortest_arc(float around, float drawn_scale_px) {
  const float scale = drawn_scale_px > 0 ? drawn_scale_px : 1;
  return std::pow(kArcStep, std::ceil(std::log(kShortestArc * around * scale) / std::log(kArcStep))) / scale;
}

}  // namespace

KnownArcs::KnownArcs(const std::vector<ShapeModel>& models, const std::vector<float>& drawn_scales_px, int pad_levels)
    : starts_(std::uint32_t(models.front().levels.back().samples.size())),
      pad_levels_(pad_levels),
      around_(models.size()),
      shortest_(models.size()) {
  const std::uint32_t of_shape = starts_ * kArcLengths;
  std::vector<PadBytes> bytes(models.size() * of_shape);
  parallel_for(models.size(), [&](std::size_t shape) {
    const Boundary boundary(models[shape], pad_levels_);
    around_[shape] = boundary.length();
    shortest_[shape] = shortest_arc(around_[shape], drawn_scales_px[shape]);
    for (std::uint32_t i = 0; i < of_shape; ++i) {
      const auto place = std::uint32_t(shape) * of_shape + i;
      const float length = length_of(place);
      std::optional<ArcSignature> signature;
      if (length < kLongestOfClosed * around_[shape])
        signature = arc_signature(points_of(place, models[shape]), length);
      bytes[place] = arc_bytes(signature, length);
    }
  });
  search_.emplace(make_pad_index(bytes, kMaxPadElements, kRecognitionScaleShare), bytes, kMaxPadLevels);
}

float KnownArcs::length_of(std::uint32_t place) const {
  return shortest_[shape_of(place)] * std::pow(kArcStep, float(place / starts_ % kArcLengths));
}

ArcPoints KnownArcs::points_of(std::uint32_t place, const ShapeModel& model) const {
  return Boundary(model, pad_levels_).arc(place % starts_, length_of(place) / around_[shape_of(place)]);
}

}  // namespace tessera
