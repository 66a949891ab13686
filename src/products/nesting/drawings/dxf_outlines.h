// Turns one entity of a DXF into a line of points.
#pragma once

#include <cstddef>

#include "products/nesting/drawings/affine.h"
#include "products/nesting/drawings/dxf_document.h"
#include "products/nesting/drawings/nurbs.h"

namespace tessera {

/// The map from an entity's own plane to that of its block or drawing; mirrored where the plane is seen from below.
Affine plane_of(const DxfEntity& entity);

/// The curve of a SPLINE under the map.
Nurbs nurbs_of(const DxfEntity& spline, const Affine& map);

/// The points of a line, arc, circle, ellipse, polyline or spline under the map, which does not include plane_of(). The
/// last point is equal to the first where the entity is closed. Curves are within kFlatness_mm where the map leads to mm. A
/// line that would have more than `most` points stops soon after that number.
NestRing dxf_outline(const DxfEntity& entity, const Affine& map, std::size_t most);

}  // namespace tessera
