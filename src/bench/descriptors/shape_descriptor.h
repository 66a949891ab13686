// Descriptors of shapes that PAD is compared with: small, plain implementations of what their papers say.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/recognition/curve.h"

namespace tessera::bench {

/// What a descriptor keeps of a shape; what the numbers mean is its own affair.
using Description = std::vector<float>;

class ShapeDescriptor {
 public:
  virtual ~ShapeDescriptor() = default;

  virtual std::string name() const = 0;
  /// `curves`: at least one, each without a curve_fault(), interior on the left; arcs of an outline are open. `unit`: a
  /// length that shapes of one size have in common, where sizes are known; else 0: the descriptor takes the shape's own.
  virtual Description describe(const std::vector<Curve>& curves, float unit) const = 0;
  /// How much two shapes differ, 0 or more; 0 for one and the same description. `query` may be of a part of a shape.
  virtual float distance(const Description& query, const Description& known) const = 0;
};

/// Shape context (Belongie, Malik and Puzicha 2002): where the other points of the boundary lie, seen from each point.
/// `points` of the whole boundary, at least 2; 100 in the paper.
std::unique_ptr<ShapeDescriptor> make_shape_context(int points = 100);
/// Triangle-area representation (Alajlan, El Rube, Kamel and Freeman 2007): areas of triangles of a point and two others
/// that lie equally far from it along the boundary.
std::unique_ptr<ShapeDescriptor> make_triangle_areas();
/// Curvature scale space (Mokhtarian, Abbasi and Kittler 1996): how much smoothing each concave segment outlives.
std::unique_ptr<ShapeDescriptor> make_curvature_scale_space();
/// Integral invariants (Manay, Hong, Yezzi and Soatto 2004): the part of a disc round a boundary point that is inside.
std::unique_ptr<ShapeDescriptor> make_integral_invariants();
/// Hu's seven invariants of the moments (1962) of the area that the boundary encloses.
std::unique_ptr<ShapeDescriptor> make_hu_moments();

/// All of them.
std::vector<std::unique_ptr<ShapeDescriptor>> all_descriptors();

}  // namespace tessera::bench
