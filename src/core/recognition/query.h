// A query: the curves of a drawing, or of its visible parts, prepared once for all comparisons. Units are the query's
// own (px of an image, or a drawing's units).
#pragma once

#include <memory>
#include <vector>

#include "core/recognition/curve_map.h"
#include "core/recognition/partial_pyramid.h"

namespace tessera {

/// The query's pyramids after smoothing by one width.
struct QueryWidth {
  float sigma = 0;
  std::vector<PartialPyramid> pyramids;  // each with has_enough_levels()
};

struct QuerySettings {
  PadParameters pad;
  /// The narrowest smoothing, query units, as the curves' own noise requires. 1.5 pixels for a clean silhouette.
  float least_sigma = 1.5f;
  /// Makes Query::without_noise().
  bool without_noise = false;
};

class Query {
 public:
  /// `curves`: at least one, each without a curve_fault().
  Query(const std::vector<Curve>& curves, const QuerySettings& settings);

  /// The query of the curves without their noise (curve_noise.h); null if they have none, or if it was not requested.
  /// Apparent noise may belong to the shape: a hedgehog's spines.
  const Query* without_noise() const { return without_noise_.get(); }
  const CurveMap& map() const { return map_; }
  /// The curves with at least kShortestShare of the total length, smoothed by the narrowest width, as evenly spaced
  /// points.
  const std::vector<Curve>& narrow_curves() const { return narrow_curves_; }
  const std::vector<QueryWidth>& widths() const { return widths_; }
  float least_sigma() const { return least_sigma_; }
  /// The length of all curves together.
  float length() const { return measures_.length; }
  /// Root mean square distance of the curves' points from their mean, `centre`.
  float radius() const { return measures_.radius; }
  Vec2 centre() const { return measures_.centre; }
  /// Longer side of the bounding box of all curves.
  float extent() const { return measures_.extent; }

 private:
  struct Measures {
    float length = 0;
    float radius = 0;
    float extent = 0;
    Vec2 centre;
  };
  static Measures measure(const std::vector<Curve>& curves);
  static CurveMap make_map(const std::vector<Curve>& curves, float sigma, const Measures& measures);
  Query(const std::vector<Curve>& curves, const QuerySettings& settings, const Measures& measures);

  CurveMap map_;
  Measures measures_;
  float least_sigma_;
  std::vector<Curve> narrow_curves_;
  std::unique_ptr<Query> without_noise_;
  std::vector<QueryWidth> widths_;
};

/// The curves, smoothed by `sigma`, as evenly spaced points: about `spacing` apart, at least 48 and at most 20,000 per
/// curve.
std::vector<Curve> even_curves(const std::vector<Curve>& curves, float sigma, float spacing);

/// Curves below this fraction of the total length are not looked up: there may be thousands.
inline constexpr float kShortestShare = 1.f / 64;

/// Ratio of successive widths of the smoothing: half an octave.
inline constexpr float kWidthStep = 1.41421356f;

}  // namespace tessera
