// Makes the outline with which the search works. It has fewer points than the piece and is never smaller, is grown by half
// the spacing, and at the end slightly reduced, so that pieces may touch.
#pragma once

#include "products/nesting/layout/nest_polygon.h"

namespace tessera {

/// The ring without points that repeat or lie on a straight side, with the interior on the left.
NestRing tidied(NestRing ring);

/// The ring without sides that go out and straight back and enclose nothing, to 1e-9 of the ring's size. A ring without
/// such sides stays the same to the bit.
NestRing without_spikes(NestRing ring);

/// A polygon that holds `ring` and has as few points as possible if at most `most_area` is added: it fills dents and
/// extends corners that were cut off.
NestRing enlarged_to_fewer_points(NestRing ring, double most_area);

/// The curve at `distance` outside the ring (interior on the left). No point is nearer, and at corners none is farther than
/// 1.04 times. Narrow dents may make the curve cross itself; what it encloses is right even then.
NestRing grown(const NestRing& ring, double distance);

/// The ring with every side moved inward by `depth`, corners by at most 8 times that. `depth` must be small compared with
/// all sides.
NestRing inset(const NestRing& ring, double depth);

}  // namespace tessera
