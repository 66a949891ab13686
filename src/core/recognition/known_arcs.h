// Arcs of several lengths on the outer boundaries of a library's shapes, with an index of their signatures.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/recognition/arc_signature.h"
#include "core/shape/shape_model.h"

namespace tessera {

/// The lengths of arcs, in px of the drawing, are powers of kArcStep, so that queries of a known scale can use the same
/// ones. A shape has kArcLengths lengths, from the first one that is at least kShortestArc of its boundary.
inline constexpr int kArcLengths = 8;
inline constexpr float kShortestArc = 1.f / 16;

class KnownArcs {
 public:
  /// `models`: all with the same levels. `drawn_scales_px`: Shape::drawn_scale_px of each model.
  KnownArcs(const std::vector<ShapeModel>& models, const std::vector<float>& drawn_scales_px, int pad_levels);

  const PadSearch& search() const { return *search_; }
  /// The shape and the arc's length (shape units) of a place that a search found.
  std::uint32_t shape_of(std::uint32_t place) const { return place / (starts_ * kArcLengths); }
  float length_of(std::uint32_t place) const;
  /// The points of the arc at `place`, shape frame. `model`: the model of its shape.
  ArcPoints points_of(std::uint32_t place, const ShapeModel& model) const;

 private:
  std::uint32_t starts_;  // number of points of a shape at which arcs begin
  int pad_levels_;
  std::vector<float> around_;    // length of the outer boundary of each shape, shape units
  std::vector<float> shortest_;  // the shortest arc of each shape, shape units
  std::optional<PadSearch> search_;
};

}  // namespace tessera
