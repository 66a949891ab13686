#include "core/relax/contacts.h"

namespace tessera {

void ContactPiece::lay(const ContactShape& of_shape, const Similarity& where) {
  shape = &of_shape;
  canvas_from_shape = where;
  scale_px = where.scale();
  samples = &of_shape.samples_at(scale_px);
  points.resize(samples->samples.size());
  for (std::size_t i = 0; i < points.size(); ++i) points[i] = where.apply(samples->samples[i].position);
  box = bounding_box(points);
}

}  // namespace tessera
