// Divides collage.svg for people who edit it: into layers, and with names of the pieces.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "result/collage_files.h"

namespace tessera {

struct SvgLayer {
  std::string id;                   // in the document
  std::string label;                // as Inkscape shows it
  std::vector<std::size_t> pieces;  // places in the list of placements, ascending
};

/// The layers of the pieces, in the order of their first pieces: one for each group of the job that has pieces
/// (shape_group.h), and one for all others. To divide them in another way, change layer_of() in svg_layers.cpp.
std::vector<SvgLayer> piece_layers(const CollageReport& report);

/// The id "piece-7-bear": the piece's index and its shape's name, with '_' for all characters but ASCII letters, digits,
/// '-' and '_'. It is unique, because all other ids of the document begin differently.
std::string svg_piece_id(std::size_t index, const std::string& shape_name);

}  // namespace tessera
