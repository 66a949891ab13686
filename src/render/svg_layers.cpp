#include "render/svg_layers.h"

#include <algorithm>
#include <cctype>
#include <map>

#include "text/utf8_text.h"

namespace tessera {
namespace {

const SvgLayer kUngrouped{.id = "layer-pieces", .label = "Pieces", .pieces = {}};

/// The layer of a group. Ids have numbers, because groups may have any name.
SvgLayer layer_of(const std::string& group, std::size_t groups_before) {
  if (group.empty()) return kUngrouped;
  return {.id = "layer-group-" + std::to_string(groups_before), .label = printable_utf8(group), .pieces = {}};
}

}  // namespace

std::vector<SvgLayer> piece_layers(const CollageReport& report) {
  std::vector<SvgLayer> layers;
  std::map<std::string, std::size_t> layer_of_group;
  for (std::size_t i = 0; i < report.placements.size(); ++i) {
    const std::string group = report.groups.empty() ? "" : report.groups[i];
    const auto [at, is_new] = layer_of_group.try_emplace(group, layers.size());
    if (is_new) layers.push_back(layer_of(group, layers.size()));
    layers[at->second].pieces.push_back(i);
  }
  return layers;
}

std::string svg_piece_id(std::size_t index, const std::string& shape_name) {
  std::string name = shape_name;
  const auto is_plain = [](unsigned char c) { return c < 0x80 && (std::isalnum(c) || c == '-' || c == '_'); };
  std::replace_if(
      name.begin(), name.end(), [&](unsigned char c) { return !is_plain(c); }, '_');
  return "piece-" + std::to_string(index) + "-" + name;
}

}  // namespace tessera
