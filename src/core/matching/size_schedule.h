// Sizes of pieces that must all find a place: how large all of them can be, and how large the next one may be so that
// the rest still finds room.
#pragma once

#include <vector>

#include "core/settings/wishes.h"

namespace tessera {

/// Pieces of one shape that must find a place: their number, and their sizes from the smallest to the largest of the
/// shape's stances.
struct WantedPieces {
  Interval scale_px;
  double count = 1;
};

/// Mean square size, px², of a shape whose sizes are spread evenly over the octaves from `low_px` to `high_px`.
double mean_square_px2(double low_px, double high_px);

/// The largest size for the next piece: the pieces that are left, none of them larger than this, fill no more than
/// kFilledByTheRest of `free_px2`. Sizes are tried downwards from the largest, in steps of kSizeStep. The result is
/// never below the smallest size of any of these pieces.
float most_scale_px(double free_px2, const std::vector<WantedPieces>& left);

/// The factor for all sizes at which the pieces fill the fraction `part` of the area. Each piece counts with half of
/// the padding all round. 0 if the padding alone takes more; 1 if no piece is wanted.
double size_factor(double area_px2, double part, const std::vector<WantedPieces>& pieces, double padding_px);

}  // namespace tessera
