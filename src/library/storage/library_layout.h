// The content of a library file (docs/library-format.md): names, types, shapes and units of its columns and attributes. A
// column is a data set whose first dimension grows. Reader and writer are both made from this list.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <tuple>
#include <vector>

#include "core/shape/shape.h"
#include "core/style/style_features.h"

namespace tessera::layout {

inline constexpr char kFormat[] = "tessera-library";
/// Rises with every change that an old reader would misread. A reader takes only its own version.
inline constexpr int kVersion = 1;

inline constexpr char kFormatAttribute[] = "format";
inline constexpr char kVersionAttribute[] = "version";
inline constexpr char kPadLevelsAttribute[] = "pad_levels";
inline constexpr char kDeltaTauAttribute[] = "pad_delta_tau_rad";
inline constexpr char kUnitsAttribute[] = "units";
inline constexpr char kDescriptionAttribute[] = "description";
inline constexpr char kSigmaAttribute[] = "sigma";
inline constexpr char kCurvePointsAttribute[] = "curve_points";
inline constexpr char kSamplesAttribute[] = "samples";

inline constexpr std::size_t kNameBytes = 256;   // NUL included
inline constexpr std::size_t kPathBytes = 4096;  // Linux' PATH_MAX
inline constexpr int kFieldNodes = 128;          // each way
inline constexpr std::size_t kSha256Bytes = std::tuple_size_v<Sha256>;
/// Digests of a shape: outline, field, then its smoothing levels.
inline constexpr std::size_t kPartDigests = 2 + kSmoothingLevels.size();

/// Upper bounds, checked when writing and, before anything is allocated, when reading.
inline constexpr std::size_t kMaxShapes = 4'000'000;
// of any column; 64 KiB for each row can still be counted
inline constexpr std::size_t kMaxRows = std::size_t(1) << 40;
inline constexpr std::size_t kMaxCurvesPerShape = 1'000;  // the builder fills holes below 0.3 % of the area
/// The builder gives the outer curve 512 points, and holes in proportion. 65,536 points belong to holes of 127 times its
/// length.
inline constexpr std::size_t kMaxPointsPerShape = 65'536;
inline constexpr int kMaxThumbnailSide_px = 192;  // as silhouette.cpp makes them
// RGBA of 192 x 192 px that does not compress takes 148,000
inline constexpr std::size_t kMaxThumbnailBytes = 160u << 10;
inline constexpr std::size_t kMaxOriginalBytes = 20u << 20;  // kMaxArtworkFileBytes: larger files are no artwork
inline constexpr std::size_t kMaxSurroundingsBytes = 20u << 20;
inline constexpr int kMaxSurroundingsMargin_px = 1024;
/// The size of all columns in memory, divided by the size of the file, is at most this. An honest library has 1.2, with
/// embedded files that deflate well 4; a forged one could have 1,000. So a file never asks for far more memory than its
/// size suggests.
inline constexpr std::uint64_t kMaxInflation = 16;
// shape units, lengths too; a shape of area 1 and this length is a hairline
inline constexpr float kMaxCoordinate = 1e4f;
inline constexpr float kLeastLength = 1e-6f;
inline constexpr float kMaxLab = 200;
inline constexpr float kMaxDrawnScale_px = 1e6f;
inline constexpr float kMostPaletteBits = 16;
inline constexpr int kMaxArtworkSize_px = 1 << 20;

enum class Element { float32, int16, int32, int64, uint64, uint8, text };

struct Column {
  std::string path;
  Element element;
  std::size_t text_bytes;             // UTF-8, filled up with NULs; 0 for other elements
  std::vector<std::size_t> row_dims;  // empty: one number in a row
  std::string units;
  std::string description;
  bool compressed = true;
};

std::size_t element_bytes(const Column& column);
std::size_t elements_per_row(const Column& column);
std::size_t row_bytes(const Column& column);

struct LevelColumns {
  Column points, perimeter, lengths, keypoints, convexity;
};

struct Columns {
  Column name, perimeter, radius, mean_lab;
  Column first_curve, first_point, outline_points;
  Column field_distance, field_scale, field_extent;
  Column artwork_path, artwork_size, artwork_centroid, artwork_unit;
  Column first_thumbnail_byte, thumbnail_bytes, first_original_byte, original_bytes;
  std::vector<LevelColumns> levels;  // one for each of kSmoothingLevels
  // Libraries of older versions lack these.
  Column part_digest, artwork_beside, artwork_sha256, artwork_reader, variant_of, colour_spread, drawn_scale,
      colour_grid, style, first_surroundings_byte, surroundings_bytes, surroundings_margin;
};

/// The group of smoothing level k.
std::string level_group(std::size_t k);

Columns library_columns(int pad_levels);

}  // namespace tessera::layout
