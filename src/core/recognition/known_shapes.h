// A range of library shapes prepared for searches: an index of their PADs for each smoothing level, and one of the arcs
// of their boundaries.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/pad/pad_search.h"
#include "core/recognition/known_arcs.h"
#include "core/shape/shape_id.h"
#include "core/shape/shape_model.h"

namespace tessera {

class KnownShapes {
 public:
  /// `models`: of the shapes first, first + 1, ... with all their parts, and all with the same levels.
  /// `drawn_scales_px`: Shape::drawn_scale_px of each.
  KnownShapes(ShapeId first, std::vector<ShapeModel> models, std::vector<float> drawn_scales_px, int pad_levels);

  /// The index of one smoothing level. Its places count the samples of all shapes, shape by shape.
  struct Level {
    int level = 0;              // index into kSmoothingLevels
    std::uint32_t samples = 0;  // samples of a shape
    PadSearch search;

    std::uint32_t shape_of(std::uint32_t place) const { return place / samples; }
    std::uint32_t sample_of(std::uint32_t place) const { return place % samples; }
  };

  std::size_t size() const { return models_.size(); }
  ShapeId id(std::uint32_t shape) const { return ShapeId(index_of(first_) + shape); }
  const ShapeModel& model(std::uint32_t shape) const { return models_[shape]; }
  float drawn_scale_px(std::uint32_t shape) const { return drawn_scales_px_[shape]; }
  const std::vector<Level>& levels() const { return levels_; }
  /// The shapes' arcs. Needs at least one shape.
  const KnownArcs& arcs() const { return *arcs_; }
  int pad_levels() const { return pad_levels_; }
  /// The key points of the sample at `place`; `level` is an index in levels().
  Keypoints keypoints_of(std::size_t level, std::uint32_t place) const;

 private:
  ShapeId first_;
  std::vector<ShapeModel> models_;
  std::vector<float> drawn_scales_px_;
  int pad_levels_;
  std::vector<Level> levels_;
  std::optional<KnownArcs> arcs_;
};

}  // namespace tessera
