// Sizes for pieces of which each must find a place: how large they can be, all together, and how large the next one may
// be, so that those that are still to come find room.
#pragma once

#include <vector>

#include "core/settings/wishes.h"

namespace tessera {

/// Pieces that are to find a place: so many of a shape whose sizes are an interval, from the smallest to the largest of
/// its stances.
struct WantedPieces {
  Interval scale_px;
  double count = 1;
};

/// Of a shape whose sizes are spread evenly over the octaves from `low_px` to `high_px`: the mean of their squares,
/// px².
double mean_square_px2(double low_px, double high_px);

/// The largest size, of a ladder that leads down from the largest of all, at which the pieces that are left, none of
/// them larger, would fill no more than kFilledByTheRest of `free_px2`. Never less than one of them needs.
float most_scale_px(double free_px2, const std::vector<WantedPieces>& left);

/// By what the sizes have to be multiplied so that the pieces, each with half of the padding all round, fill this part
/// of the area. 0 where the padding alone takes more; 1 where no piece is wanted.
double size_factor(double area_px2, double part, const std::vector<WantedPieces>& pieces, double padding_px);

}  // namespace tessera
