// How collage.svg is divided for those who edit it: layers, and the names of the pieces.
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

/// The layers that the pieces lie in, in the order of their first pieces: one for each group of the job that has pieces
/// (shape_group.h), and one for all others. To divide them otherwise, say in layer_of (svg_layers.cpp) where a piece
/// belongs.
std::vector<SvgLayer> piece_layers(const CollageReport& report);

/// "piece-7-bear": the piece's index and its shape's name, with '_' for all but ASCII letters, digits, '-' and
/// '_'. Unique, since all other ids of the document begin in other ways.
std::string svg_piece_id(std::size_t index, const std::string& shape_name);

}  // namespace tessera
