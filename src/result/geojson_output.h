// Writes pieces.geojson: every placed piece as a polygon with holes, for other programs (cutters, maps).
#pragma once

#include <string>

#include "result/collage_files.h"

namespace tessera {

/// A FeatureCollection with one Polygon for each placement, in order of placement. Coordinates are canvas px, y down. Rings
/// are closed; the shoelace area of the outer ring is positive, that of holes negative (RFC 7946's right-hand rule applied
/// to the numbers). All numbers have fixed decimals, so that equal collages give equal bytes.
std::string geojson_text(const CollageReport& report);

}  // namespace tessera
