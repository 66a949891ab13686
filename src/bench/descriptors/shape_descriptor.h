// Descriptors of shapes, for comparison with PADs: small, plain implementations of their papers.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/recognition/curve.h"

namespace tessera::bench {

/// A description of a shape; only its descriptor knows what the numbers mean.
using Description = std::vector<float>;

class ShapeDescriptor {
 public:
  virtual ~ShapeDescriptor() = default;

  virtual std::string name() const = 0;
  /// Describes a shape. `curves`: at least one, each without a curve_fault(), interior on the left; arcs of an outline
  /// are open. `unit`: where sizes are known, a length that shapes of one size share; 0: the shape's own size is used.
  virtual Description describe(const std::vector<Curve>& curves, float unit) const = 0;
  /// The difference of two shapes, 0 or more; 0 for equal descriptions. `query` may describe only a part of a shape.
  virtual float distance(const Description& query, const Description& known) const = 0;
};

/// Shape context (Belongie, Malik and Puzicha 2002): the distribution of the other boundary points round each point.
/// `points`: number for the whole boundary, at least 2; 100 in the paper.
std::unique_ptr<ShapeDescriptor> make_shape_context(int points = 100);
/// Triangle-area representation (Alajlan, El Rube, Kamel and Freeman 2007): areas of the triangles of a point and two
/// others at equal distances from it along the boundary.
std::unique_ptr<ShapeDescriptor> make_triangle_areas();
/// Curvature scale space (Mokhtarian, Abbasi and Kittler 1996): the smoothing at which each concave segment disappears.
std::unique_ptr<ShapeDescriptor> make_curvature_scale_space();
/// Integral invariants (Manay, Hong, Yezzi and Soatto 2004): the part of a disc round a boundary point that is inside.
std::unique_ptr<ShapeDescriptor> make_integral_invariants();
/// Hu's seven invariants of the moments (1962) of the area that the boundary encloses.
std::unique_ptr<ShapeDescriptor> make_hu_moments();

/// All of them.
std::vector<std::unique_ptr<ShapeDescriptor>> all_descriptors();

}  // namespace tessera::bench
