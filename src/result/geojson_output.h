// pieces.geojson: every piece as a polygon with holes, as placed, for programs that go on from here (cutters, maps).
#pragma once

#include <string>

#include "result/collage_files.h"

namespace tessera {

/// A FeatureCollection of one Polygon per placement, in order of placement. Coordinates are canvas px, y down. Rings
/// are closed; the outer one has positive, holes have negative shoelace area (RFC 7946's right-hand rule in the
/// numbers). All numbers have fixed decimals, so that equal collages give equal bytes.
std::string geojson_text(const CollageReport& report);

}  // namespace tessera
