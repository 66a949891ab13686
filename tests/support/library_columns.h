// The columns of a library file as a list, for tests that apply to every column.
#pragma once

#include <vector>

#include "library/storage/library_layout.h"

namespace tessera::test {

/// All columns except those of the smoothing levels. If a column is missing in the structured binding, this does not compile.
inline std::vector<layout::Column> columns_beside_levels(const layout::Columns& columns) {
  const auto& [name, perimeter, radius, mean_lab, first_curve, first_point, outline_points, field_distance, field_scale,
               field_extent, artwork_path, artwork_size, artwork_centroid, artwork_unit, first_thumbnail_byte,
               thumbnail_bytes, first_original_byte, original_bytes, levels, part_digest, artwork_beside,
               artwork_sha256, artwork_reader, variant_of, colour_spread, drawn_scale, colour_grid, style,
               first_surroundings_byte, surroundings_bytes, surroundings_margin] = columns;
  return {name,
          perimeter,
          radius,
          mean_lab,
          first_curve,
          first_point,
          outline_points,
          field_distance,
          field_scale,
          field_extent,
          artwork_path,
          artwork_size,
          artwork_centroid,
          artwork_unit,
          first_thumbnail_byte,
          thumbnail_bytes,
          first_original_byte,
          original_bytes,
          part_digest,
          artwork_beside,
          artwork_sha256,
          artwork_reader,
          variant_of,
          colour_spread,
          drawn_scale,
          colour_grid,
          style,
          first_surroundings_byte,
          surroundings_bytes,
          surroundings_margin};
}

inline std::vector<layout::Column> all_columns(const layout::Columns& columns) {
  std::vector<layout::Column> all = columns_beside_levels(columns);
  for (const layout::LevelColumns& level : columns.levels) {
    const auto& [points, perimeter, lengths, keypoints, convexity] = level;
    all.insert(all.end(), {points, perimeter, lengths, keypoints, convexity});
  }
  return all;
}

}  // namespace tessera::test
