// Reads the polygons of a GeoJSON file of any origin, one feature after the other. The file may be hostile: only polygons
// and names are kept, and their number has limits.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "core/geometry/vec2.h"
#include "text/json_file.h"

namespace tessera {

/// A closed ring; its last position is equal to the first.
using Ring = std::vector<Vec2>;

struct PolygonFeature {
  std::string shape;                        // properties.shape; empty: there is none
  std::vector<std::vector<Ring>> polygons;  // each has the outer ring first, then its holes; a Polygon gives one
};

inline constexpr std::size_t kMostFeatures = 100'000;
inline constexpr std::size_t kMostFeaturePoints = 20'000;  // in one feature
inline constexpr std::size_t kMostPoints = 25'000'000;     // in all features
inline constexpr std::size_t kMostShapeNameBytes = 1'000;
inline constexpr double kLeastCoordinate = -20'000;  // the range in which a job may give pieces
inline constexpr double kMostCoordinate = 40'000;

/// Calls `take` with the features of a FeatureCollection of Polygons and MultiPolygons, in their order. It skips a third
/// number in a position. Throws InputError that names the feature (from 0), the key, what was found and what is allowed. An
/// InputError of `take` gets the feature's number, too. The caller adds the name of the file.
void read_polygon_features(JsonFile& file, const std::function<void(PolygonFeature)>& take);

}  // namespace tessera
