#include "library/storage/library_layout.h"

namespace tessera::layout {
namespace {

constexpr char kShapeUnits[] = "shape units (square root of the silhouette's area)";
constexpr char kBytes[] = "bytes";
constexpr char kNone[] = "1";

Column text(const std::string& path, std::size_t bytes, const std::string& description) {
  return {path, Element::text, bytes, {}, kNone, description};
}

Column offsets(const std::string& path, const std::string& units, const std::string& description) {
  return {path, Element::int64, 0, {}, units, description};
}

Column floats(const std::string& path, std::vector<std::size_t> row_dims, const std::string& units,
              const std::string& description) {
  return {path, Element::float32, 0, std::move(row_dims), units, description};
}

Column bytes(const std::string& path, const std::string& description) {
  return {path, Element::uint8, 0, {}, kBytes, description};
}

LevelColumns level_columns(std::size_t k, std::size_t n) {
  const std::string group = level_group(k) + "/";
  const std::size_t points = kSmoothingLevels[k].curve_points;
  const std::size_t samples = kSmoothingLevels[k].samples;
  return {
      floats(group + "points", {points, 2}, kShapeUnits, "smoothed outer curve, even arclength, x y"),
      floats(group + "perimeter", {}, kShapeUnits, "length of the smoothed curve"),
      floats(group + "lengths", {samples, 2 * n}, kShapeUnits,
             "arclengths l_{n-1} .. l_0 r_0 .. r_{n-1} of each sample"),
      floats(group + "keypoints", {samples, 2 * n + 1, 2}, kShapeUnits,
             "left end of level n-1 .. of level 0, the sample, right end of level 0 .. of level n-1, x y"),
      floats(group + "convexity", {samples}, kNone, "+1 convex, -1 concave, 0 flat"),
  };
}

}  // namespace

std::string level_group(std::size_t k) { return "/levels/" + std::to_string(k); }

std::size_t element_bytes(const Column& column) {
  switch (column.element) {
    case Element::uint8: return 1;
    case Element::int16: return 2;
    case Element::float32:
    case Element::int32: return 4;
    case Element::int64:
    case Element::uint64: return 8;
    case Element::text: return column.text_bytes;
  }
  return 0;
}

std::size_t elements_per_row(const Column& column) {
  std::size_t count = 1;
  for (const std::size_t dim : column.row_dims) count *= dim;
  return count;
}

std::size_t row_bytes(const Column& column) { return element_bytes(column) * elements_per_row(column); }

// The table of columns, one in each row.
Columns library_columns(int pad_levels) {
  Columns c{
      .name = text("/shapes/name", kNameBytes, "file name without extension, unique"),
      .perimeter = floats("/shapes/perimeter", {}, kShapeUnits, "length of all curves of the outline"),
      .radius = floats("/shapes/radius", {}, kShapeUnits, "largest distance of an outline point from the origin"),
      .mean_lab = floats("/shapes/mean_lab", {3}, "CIELAB (D65)", "alpha-weighted mean colour of the artwork"),
      .first_curve =
          offsets("/outline/first_curve", "curves",
                  "shape i has the curves first_curve[i] .. first_curve[i + 1] - 1; the first is the outer one"),
      .first_point =
          offsets("/outline/first_point", "points", "curve c has the points first_point[c] .. first_point[c + 1] - 1"),
      .outline_points = floats("/outline/points", {2}, kShapeUnits, "closed curves, interior on the left, x y"),
      .field_distance = {"/field/distance",
                         Element::int16,
                         0,
                         {kFieldNodes, kFieldNodes},
                         "scale[i] shape units",
                         "signed distance to the outline, positive outside; row y, column x, node 0 at -extent[i]",
                         false},  // shrinks by a third only, and inflating would be most of reading a shape
      .field_scale = floats("/field/scale", {}, kShapeUnits, "one step of /field/distance"),
      .field_extent = floats("/field/extent", {}, kShapeUnits, "the field spans [-extent, extent] both ways"),
      .artwork_path = text("/artwork/path", kPathBytes, "absolute path of the artwork when the library was built"),
      .artwork_size = {"/artwork/size", Element::int32, 0, {2}, "artwork px", "width, height of the traced raster"},
      .artwork_centroid = floats("/artwork/centroid", {2}, "artwork px", "the shape's origin in the raster, x y"),
      .artwork_unit = floats("/artwork/unit", {}, "artwork px", "length of one shape unit"),
      .first_thumbnail_byte = offsets("/artwork/first_thumbnail_byte", kBytes,
                                      "shape i has thumbnail_png[first[i]] .. thumbnail_png[first[i + 1] - 1]"),
      .thumbnail_bytes = bytes("/artwork/thumbnail_png", "RGBA PNG files, one after another"),
      .first_original_byte = offsets("/artwork/first_original_byte", kBytes,
                                     "shape i has original[first[i]] .. original[first[i + 1] - 1]"),
      .original_bytes = bytes("/artwork/original", "embedded artwork files, one after another; empty without --embed"),
      .levels = {},
      .part_digest = {"/shapes/part_digest",
                      Element::uint64,
                      0,
                      {kPartDigests},
                      kNone,
                      "of what the columns hold of the shape's outline, field, smoothing levels 0, 1 .."},
      .artwork_beside = text("/artwork/path_from_library", kPathBytes,
                             "the artwork's path from the library's folder when the library was built"),
      .artwork_sha256 = {"/artwork/sha256",
                         Element::uint8,
                         0,
                         {kSha256Bytes},
                         kNone,
                         "of the artwork's file when the library was built; zeros: unknown"},
      .artwork_reader =
          {"/artwork/reader",
           Element::int32,
           0,
           {},
           kNone,
           "the way of reading drawings that the shape was made by: 1 as stored, 2 turned as EXIF data say"},
      .variant_of = {"/shapes/variant_of",
                     Element::int32,
                     0,
                     {},
                     "shapes",
                     "the first shape with the same silhouette, itself where there is none before it"},
      .colour_spread = floats("/shapes/colour_spread", {}, "CIELAB (D65)",
                              "root mean square distance of the artwork's colours from mean_lab; negative: unknown"),
      .drawn_scale = floats("/shapes/drawn_scale", {}, "px of an image, 1/96 inch of an SVG",
                            "the square root of the area that the shape has in the artwork; 0: unknown"),
      .colour_grid = {"/shapes/colour_grid",
                      Element::uint8,
                      0,
                      {kColourSide, kColourSide, 4},
                      "L x 2.55, a + 128, b + 128, part x 255",
                      "mean CIELAB (D65) of each cell of a grid over the outline's box, row by row, and how much of it "
                      "is drawn on; all 0: unknown"},
      .style =
          floats("/shapes/style", {kStyleNumbers}, "1, see description",
                 "width of lines (shape units), part of the area that is lines, part of the boundary that is, "
                 "entropy of the colours (bits), chroma (CIELAB), texture (CIELAB), shaded part, part beside edges; "
                 "negative entropy: unknown"),
      .first_surroundings_byte =
          offsets("/artwork/first_surroundings_byte", kBytes,
                  "shape i has surroundings_png[first[i]] .. surroundings_png[first[i + 1] - 1]"),
      .surroundings_bytes =
          bytes("/artwork/surroundings_png",
                "RGBA PNG files, one after another: the original and what lies round it in its photo; "
                "alpha 128 where other elements are"),
      .surroundings_margin = {"/artwork/surroundings_margin",
                              Element::int32,
                              0,
                              {},
                              "px of the original",
                              "what surroundings_png shows more than the original, on each side; 0: no surroundings"},
  };
  for (std::size_t k = 0; k < kSmoothingLevels.size(); ++k)
    c.levels.push_back(level_columns(k, std::size_t(pad_levels)));
  return c;
}

}  // namespace tessera::layout
