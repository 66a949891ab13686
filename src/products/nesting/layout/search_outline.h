// The outline that a piece is searched a place with: never smaller than the piece, with fewer points, grown by half the
// spacing, and a touch smaller at the end, so that pieces may touch.
#pragma once

#include "products/nesting/layout/nest_polygon.h"

namespace tessera {

/// Without points that repeat or lie on a straight side, the interior on the left.
NestRing tidied(NestRing ring);

/// Without sides that go out and straight back, which enclose nothing: to 1e-9 of the ring's size. A ring without any is
/// the same to the bit.
NestRing without_spikes(NestRing ring);

/// A polygon that holds `ring` and has as few points as adding `most_area` in all allows: dents are filled, and corners
/// that were cut off come back.
NestRing enlarged_to_fewer_points(NestRing ring, double most_area);

/// The curve at `distance` outside of the ring (interior on the left): no point is nearer, and at corners none farther
/// than 1.04 times. Narrow dents may make it cross itself; what it encloses is right then, too.
NestRing grown(const NestRing& ring, double distance);

/// Every side moved inside by `depth`, corners by no more than 8 times that. `depth` is small beside all sides.
NestRing inset(const NestRing& ring, double depth);

}  // namespace tessera
