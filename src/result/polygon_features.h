// The polygons of a GeoJSON file, ours or anyone's, one feature after the other. The file may be hostile: nothing of it
// but the polygons and names is kept, and their number has limits.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "core/geometry/vec2.h"
#include "text/json_file.h"

namespace tessera {

/// A closed ring; the last position is the first again.
using Ring = std::vector<Vec2>;

struct PolygonFeature {
  std::string shape;                        // of properties.shape; empty: there is none
  std::vector<std::vector<Ring>> polygons;  // of each the outer ring first, then its holes; one of a Polygon
};

inline constexpr std::size_t kMostFeatures = 100'000;
inline constexpr std::size_t kMostFeaturePoints = 20'000;  // of one feature
inline constexpr std::size_t kMostPoints = 25'000'000;     // of all features
inline constexpr std::size_t kMostShapeNameBytes = 1'000;
inline constexpr double kLeastCoordinate = -20'000;  // as pieces of a job may be given
inline constexpr double kMostCoordinate = 40'000;

/// Hands out the features of a FeatureCollection of Polygons and MultiPolygons in their order. A third number of a
/// position is passed over. Throws InputError that names the feature, from 0, the key, what was found and what is
/// allowed; what `take` throws as InputError gets the feature's number, too. The name of the file is the caller's to
/// add.
void read_polygon_features(JsonFile& file, const std::function<void(PolygonFeature)>& take);

}  // namespace tessera
