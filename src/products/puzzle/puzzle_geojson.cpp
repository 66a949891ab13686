#include "products/puzzle/puzzle_geojson.h"

#include <nlohmann/json.hpp>

#include "text/number_text.h"
#include "text/pose.h"

namespace tessera {
namespace {

using nlohmann::ordered_json;

ordered_json position(Vec2 p) { return {rounded(p.x, kPixelDecimals), rounded(p.y, kPixelDecimals)}; }

ordered_json feature(const LaidPuzzlePiece& piece) {
  const Similarity& pose = piece.canvas_from_shape;
  ordered_json ring = ordered_json::array();
  for (const Vec2 p : piece.outline_px) ring.push_back(position(p));
  ring.push_back(position(piece.outline_px.front()));
  return {{"type", "Feature"},
          {"properties",
           {{"shape", piece.shape},
            {"scale", rounded(pose.scale(), kPixelDecimals)},
            {"rotation_deg", rounded(rotation_deg(pose), kPixelDecimals)},
            {"x_px", rounded(pose.tx, kPixelDecimals)},
            {"y_px", rounded(pose.ty, kPixelDecimals)},
            {"canvas_from_shape", {double(pose.a), double(pose.b), double(pose.tx), double(pose.ty)}}}},
          {"geometry", {{"type", "Polygon"}, {"coordinates", ordered_json::array({ring})}}}};
}

}  // namespace

std::string puzzle_geojson(const std::vector<LaidPuzzlePiece>& pieces) {
  std::string text = R"({"type":"FeatureCollection","features":[)";
  for (std::size_t i = 0; i < pieces.size(); ++i) text += (i > 0 ? ",\n" : "\n") + feature(pieces[i]).dump();
  return text + "\n]}\n";
}

}  // namespace tessera
