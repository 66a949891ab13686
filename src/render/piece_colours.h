// Chooses a colour of a palette for each piece of a collage.
#pragma once

#include <string>
#include <vector>

#include "library/storage/shape_library.h"
#include "result/collage_files.h"

namespace tessera {

/// Whether pieces are drawn as silhouettes in colours of a palette.
bool draws_palette(const ColourSpec& colour, const ShapeLibrary& library);

/// A colour for each piece of the report; `placements` are the poses. Where the pieces show a picture (report.covered), it
/// is the colour nearest to what the piece covers. Otherwise shape and pose decide a random order of the palette, and the
/// first colour that no earlier neighbour has is taken; where all are taken, the one that the fewest neighbours have. So it
/// depends on the piece and its earlier neighbours only: later pieces change nothing, and taking one away changes at most
/// those later pieces that lay beside it. The shapes must have their fields. If tessera draw shall give a result the same
/// colours, `placements` must be those of as_written(). `padding_px`: the distance that the pieces keep.
std::vector<std::string> piece_colours(const CollageReport& report, const std::vector<Placement>& placements,
                                       const std::vector<std::string>& palette, float padding_px);

}  // namespace tessera
