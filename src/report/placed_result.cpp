#include "report/placed_result.h"

#include <nlohmann/json.hpp>

#include "core/base/error.h"
#include "core/base/rank_pool.h"
#include "job/canvas/canvas_file.h"
#include "result/folder/result_file.h"
#include "result/piece_properties.h"
#include "result/polygon_pieces.h"

namespace tessera {
namespace {

using nlohmann::json;

constexpr const char* kPieces = "pieces.geojson";

ShownPiece piece_of(const json& properties) {
  return {.shape = properties.at("shape"),
          .source = properties.value("source", ""),
          .group = properties.value("group", ""),
          .x_px = properties.at("x_px"),
          .y_px = properties.at("y_px"),
          .scale_px = properties.at("scale"),
          .rotation_deg = properties.at("rotation_deg"),
          .score = properties.value("score", 0.),
          .matched_px = properties.value("matched_px", 0.),
          .mirrored = properties.value("mirrored", false),
          .locked = properties.value("locked", false)};
}

std::vector<ShownPiece> read_properties(const std::string& folder) {
  static const std::vector<std::string_view> kRead = {
      "shape", "source", "group", "x_px", "y_px", "scale", "rotation_deg", "score", "matched_px", "mirrored", "locked"};
  std::vector<ShownPiece> pieces;
  read_piece_properties(folder, kRead, [&](const json& properties) { pieces.push_back(piece_of(properties)); });
  return pieces;
}

}  // namespace

PlacedResult read_placed_result(const std::string& folder) {
  PlacedResult result{.folder = folder, .whole = read_result(folder), .canvas = {}, .pieces = {}, .outlines = {}};
  result.canvas = canvas_of(result.whole.job);
  // Both read the whole file, which may have hundreds of MB.
  run_both([&] { result.outlines = read_polygon_pieces(path_in_result(folder, kPieces), result.canvas); },
           [&] { result.pieces = read_properties(folder); });
  if (result.pieces.size() == result.outlines.size()) return result;
  throw InputError(path_in_result(folder, kPieces) + ": has changed while it was read");
}

}  // namespace tessera
