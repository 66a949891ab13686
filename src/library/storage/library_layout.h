// What a library file consists of (docs/library-format.md): the names, types, shapes and units of its columns and
// attributes. A column is a data set whose first dimension grows; reader and writer are both made from this list.
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
/// Counted up with every change that an old reader would misread. A reader takes its own version only.
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

/// Sane maxima, checked when written and when read, before anything is allocated.
inline constexpr std::size_t kMaxShapes = 4'000'000;
inline constexpr std::size_t kMaxRows = std::size_t(1) << 40;  // of any column: so many times 64 KiB can be counted
inline constexpr std::size_t kMaxCurvesPerShape = 1'000;       // the builder fills holes below 0.3 % of the area
/// The builder gives the outer curve 512 points, and holes in proportion to it: 127 times its length would be 65,536.
inline constexpr std::size_t kMaxPointsPerShape = 65'536;
inline constexpr int kMaxThumbnailSide_px = 192;               // as silhouette.cpp makes them
inline constexpr std::size_t kMaxThumbnailBytes = 160u << 10;  // RGBA of 192 x 192 px that does not shrink: 148,000
inline constexpr std::size_t kMaxOriginalBytes = 20u << 20;    // kMaxArtworkFileBytes: no larger file is artwork
/// All columns in memory, in parts of the file's size. An honest library has 1.2, with originals that deflate well 4; a
/// forged one could have 1,000. So a file asks for no more memory than its own size leads to expect.
inline constexpr std::uint64_t kMaxInflation = 16;
inline constexpr float kMaxCoordinate = 1e4f;  // shape units, lengths too; a shape of area 1 that long is a hairline
inline constexpr float kLeastLength = 1e-6f;
inline constexpr float kMaxLab = 200;
inline constexpr float kMaxDrawnScale_px = 1e6f;
inline constexpr float kMostPaletteBits = 16;
inline constexpr int kMaxArtworkSize_px = 1 << 20;

enum class Element { float32, int16, int32, int64, uint64, uint8, text };

struct Column {
  std::string path;
  Element element;
  std::size_t text_bytes;             // of Element::text, which is UTF-8 that ends with NULs; otherwise 0
  std::vector<std::size_t> row_dims;  // empty: one number a row
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
      colour_grid, style;
};

/// The group of smoothing level k.
std::string level_group(std::size_t k);

Columns library_columns(int pad_levels);

}  // namespace tessera::layout
