#include "result/placed_pieces.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "core/base/error.h"
#include "result/geojson_output.h"
#include "result/piece_properties.h"
#include "text/number_text.h"
#include "text/pose.h"

namespace tessera {
namespace {

using nlohmann::json;

Similarity transform_of(const json& properties) {
  const double scale = properties.at("scale");
  const Similarity t = pose_of(scale, properties.at("rotation_deg"), properties.at("x_px"), properties.at("y_px"));
  if (!(scale > 0) || !std::isfinite(t.a + t.b + t.tx + t.ty)) throw InputError("a piece without a size or place");
  return t;
}

PlacedPiece piece_of(const json& properties) {
  return {properties.at("shape"), transform_of(properties), properties.value("locked", false),
          properties.contains("canvas_from_shape")};
}

/// The value with the decimals of the file.
double written(double value) { return std::stod(fixed(value, kPixelDecimals)); }

}  // namespace

std::vector<PlacedPiece> read_placed_pieces(const std::string& dir) {
  static const std::vector<std::string_view> kRead = {"shape", "scale",  "rotation_deg",     "x_px",
                                                      "y_px",  "locked", "canvas_from_shape"};
  std::vector<PlacedPiece> pieces;
  read_piece_properties(dir, kRead, [&](const json& properties) { pieces.push_back(piece_of(properties)); });
  return pieces;
}

std::vector<Placement> as_written(std::vector<Placement> placements) {
  for (Placement& placement : placements) {
    const Similarity& t = placement.canvas_from_shape;
    placement.canvas_from_shape = pose_of(written(t.scale()), written(rotation_deg(t)), written(t.tx), written(t.ty));
  }
  return placements;
}

}  // namespace tessera
