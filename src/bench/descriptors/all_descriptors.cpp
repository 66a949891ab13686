#include "bench/descriptors/shape_descriptor.h"

namespace tessera::bench {

std::vector<std::unique_ptr<ShapeDescriptor>> all_descriptors() {
  std::vector<std::unique_ptr<ShapeDescriptor>> all;
  all.push_back(make_shape_context());
  all.push_back(make_triangle_areas());
  all.push_back(make_curvature_scale_space());
  all.push_back(make_integral_invariants());
  all.push_back(make_hu_moments());
  return all;
}

}  // namespace tessera::bench
