// Measures how well a mosaic shows its picture from a distance at which single pieces are not visible. Mosaic and
// picture are reduced to a few pixels, then compared by colour and by structure.
#pragma once

#include <optional>

#include "core/colour/area_means.h"

namespace tessera {

/// Width to which mosaic and picture are reduced. It is the same for all mosaics, so that their figures can be
/// compared.
inline constexpr int kAfarWidth_px = 100;

/// A mosaic and the picture that it shows, on the same cells.
struct PicturePair {
  Grid<Srgb> mosaic;
  Grid<Srgb> picture;
  Grid<float> weight;  // weight of each cell, 0..1: 0 outside the canvas and where the picture is transparent
};

/// The differences of mosaic and picture after both are reduced to this number of pixels.
struct AfarFigures {
  int width_px = 0;
  int height_px = 0;
  double colour_difference = 0;  // mean CIEDE2000 over the pixels; 0: equal, 100: black for white
  double structure = 1;          // SSIM of the greys; 1: equal
};

struct SeenFromAfar {
  AfarFigures at_100_px;  // with fewer px if there are fewer cells
  std::optional<AfarFigures> at_piece_size;
};

/// Reduces both to `width_px`, or to the number of cells if that is less. Pixels are means of coded sRGB values, as
/// image programs and browsers reduce pictures. Empty if no cell has weight.
std::optional<AfarFigures> figures_from_afar(const PicturePair& pair, int width_px);

/// The figures at 100 px, and at the width at which a piece of mean size is one pixel. `width_in_pieces`: the mosaic's
/// width in such pieces; 0: there are no pieces. Empty if no cell has weight.
std::optional<SeenFromAfar> seen_from_afar(const PicturePair& pair, double width_in_pieces);

}  // namespace tessera
