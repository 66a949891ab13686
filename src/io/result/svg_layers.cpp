#include "io/result/svg_layers.h"

#include <algorithm>
#include <cctype>
#include <utility>

namespace tessera::io {
namespace {

SvgLayer layer_of(const Placement&) { return {.id = "layer-pieces", .label = "Pieces", .pieces = {}}; }

}  // namespace

std::vector<SvgLayer> piece_layers(const std::vector<Placement>& placements) {
  std::vector<SvgLayer> layers;
  for (std::size_t i = 0; i < placements.size(); ++i) {
    SvgLayer layer = layer_of(placements[i]);
    auto found = std::find_if(layers.begin(), layers.end(), [&](const SvgLayer& l) { return l.id == layer.id; });
    if (found == layers.end()) found = layers.insert(layers.end(), std::move(layer));
    found->pieces.push_back(i);
  }
  return layers;
}

std::string svg_piece_id(std::size_t index, const std::string& shape_name) {
  std::string name = shape_name;
  const auto is_plain = [](unsigned char c) { return c < 0x80 && (std::isalnum(c) || c == '-' || c == '_'); };
  std::replace_if(name.begin(), name.end(), [&](unsigned char c) { return !is_plain(c); }, '_');
  return "piece-" + std::to_string(index) + "-" + name;
}

}  // namespace tessera::io
