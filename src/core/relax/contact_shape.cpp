#include "core/relax/contact_shape.h"

namespace tessera {
namespace {

/// The sampling of the boundary for pieces larger than a scale. Lengths in shape units.
struct Density {
  float above_px;
  float spacing;
  float tolerance;
};

constexpr std::array<Density, kContactDensities> kDensities = {{
    {64, 0.025f, 0.003f},
    {27, 0.05f, 0.006f},
    {0, 0.12f, 0.012f},
}};

}  // namespace

const BoundarySamples& ContactShape::samples_at(float scale_px) const {
  int density = 0;
  while (density + 1 < kContactDensities && scale_px <= kDensities[density].above_px) ++density;
  return samples[density];
}

ContactShape make_contact_shape(const Shape& shape, float sparser) {
  ContactShape made;
  for (int k = 0; k < kContactDensities; ++k) {
    made.samples[k] =
        sample_boundary(shape.outline, sparser * kDensities[k].spacing, sparser * kDensities[k].tolerance);
  }
  made.outline = shape.outline;
  made.field = shape.field;
  made.nodes_per_unit = float(shape.field.distance.width() - 1) / (2 * shape.field.extent);
  made.perimeter = shape.perimeter;
  made.radius = shape.radius;
  return made;
}

}  // namespace tessera
