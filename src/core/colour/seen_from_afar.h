// How well a mosaic shows its picture to whoever stands far off and sees no single piece: both are reduced to few
// pixels, then compared by colour and by structure.
#pragma once

#include <optional>

#include "core/colour/area_means.h"

namespace tessera {

/// Width to which both are reduced, whatever the mosaic: figures of different mosaics can be compared.
inline constexpr int kAfarWidth_px = 100;

/// A mosaic and the picture that it shows, in the same cells.
struct PicturePair {
  Grid<Srgb> mosaic;
  Grid<Srgb> picture;
  Grid<float> weight;  // how much a cell counts, 0..1: 0 outside the canvas and where the picture is transparent
};

/// How far mosaic and picture are apart once both are reduced to so many pixels.
struct AfarFigures {
  int width_px = 0;
  int height_px = 0;
  double colour_difference = 0;  // mean of CIEDE2000 over the pixels; 0: equal, 100: black for white
  double structure = 1;          // SSIM of the greys; 1: equal
};

struct SeenFromAfar {
  AfarFigures at_100_px;  // of fewer px where the cells are fewer
  std::optional<AfarFigures> at_piece_size;
};

/// Both reduced to so many px, as many as there are cells at most. Pixels are means of sRGB as it is coded, as image
/// programs and browsers reduce pictures. None where nothing counts.
std::optional<AfarFigures> figures_from_afar(const PicturePair& pair, int width_px);

/// The figures at 100 px, and at the width at which a piece of mean size is one pixel: the mosaic is `width_in_pieces`
/// times as wide as such a piece; 0: there are no pieces. None where nothing counts.
std::optional<SeenFromAfar> seen_from_afar(const PicturePair& pair, double width_in_pieces);

}  // namespace tessera
