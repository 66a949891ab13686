#include "io/result/placed_pieces.h"

#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "core/base/error.h"
#include "io/result/result_file.h"

namespace tessera::io {
namespace {

using nlohmann::json;

/// Polygons are most of the file, and not needed.
bool keep(int, json::parse_event_t event, json& parsed) {
  return event != json::parse_event_t::key || parsed != "geometry";
}

Similarity transform_of(const json& feature) {
  const json& properties = feature.at("properties");
  const double scale = properties.at("scale");
  const double angle = properties.at("rotation_deg").get<double>() * std::numbers::pi / 180;
  const Similarity t{float(scale * std::cos(angle)), float(scale * std::sin(angle)), properties.at("x_px"),
                     properties.at("y_px")};
  if (!(scale > 0) || !std::isfinite(t.a + t.b + t.tx + t.ty)) throw InputError("a piece without a size or place");
  return t;
}

}  // namespace

std::vector<Similarity> read_placed_pieces(const std::string& dir) {
  const std::string bytes = read_result_file(dir, "pieces.geojson");
  const std::string path = path_in_result(dir, "pieces.geojson");
  std::vector<Similarity> pieces;
  try {
    const json collection = json::parse(bytes, keep);
    for (const json& feature : collection.at("features")) pieces.push_back(transform_of(feature));
  } catch (const json::exception& error) {
    throw InputError(path + ": not a pieces.geojson of tessera collage: " + error.what());
  } catch (const InputError& error) {
    throw InputError(path + ": " + error.what());
  }
  return pieces;
}

}  // namespace tessera::io
