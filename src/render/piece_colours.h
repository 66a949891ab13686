// Which colour of a palette each piece of a collage gets.
#pragma once

#include <string>
#include <vector>

#include "library/storage/shape_library.h"
#include "result/collage_files.h"

namespace tessera {

/// Whether pieces are silhouettes in colours of a palette.
bool draws_palette(const ColourSpec& colour, const ShapeLibrary& library);

/// A colour for each piece of the report, which lies as `placements` say. Where the pieces show a picture
/// (report.covered): the one that is nearest to what the piece covers. Else: what the shape and its pose draw by lot
/// comes first; a colour that an earlier neighbour has is passed over, so that neighbours differ wherever the palette
/// has a colour left (else it is the one that the fewest of them have). It depends on the piece and on its earlier
/// neighbours alone: pieces placed later change nothing, and taking one away changes at most those that lay beside it
/// and came later. The shapes have their fields. Where a result is to be given the same colours by tessera draw, these
/// must be those of as_written. `padding_px`: the distance that the pieces keep.
std::vector<std::string> piece_colours(const CollageReport& report, const std::vector<Placement>& placements,
                                       const std::vector<std::string>& palette, float padding_px);

}  // namespace tessera
