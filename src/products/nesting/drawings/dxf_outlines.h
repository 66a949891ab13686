// One entity of a DXF as a line of points.
#pragma once

#include <cstddef>

#include "products/nesting/drawings/affine.h"
#include "products/nesting/drawings/dxf_document.h"
#include "products/nesting/drawings/nurbs.h"

namespace tessera {

/// The map from an entity's own plane to that of the block or drawing that it lies in: mirrored where the plane is seen
/// from below.
Affine plane_of(const DxfEntity& entity);

/// The curve of a SPLINE under the map.
Nurbs nurbs_of(const DxfEntity& spline, const Affine& map);

/// The points of a line, arc, circle, ellipse, polyline or spline under the map, which does not hold plane_of. The last
/// point is the first one where the entity is closed. Curves are kFlatness_mm close where the map leads to mm. It has
/// little more points than `most` where it would have more.
NestRing dxf_outline(const DxfEntity& entity, const Affine& map, std::size_t most);

}  // namespace tessera
