// How large the next piece may be, so that all shapes that are still to come find room: large ones first, ever smaller
// ones then. The sizes of a shape are an interval: from the smallest to the largest of its stances.
#pragma once

#include <vector>

#include "core/wishes.h"

namespace tessera {

/// Of a shape whose sizes are spread evenly over the octaves from `low_px` to `high_px`: the mean of their squares,
/// px².
double mean_square_px2(double low_px, double high_px);

/// The largest size, of a ladder that leads down from the largest of all, at which the shapes that are left, none of
/// them larger, would fill no more than kFilledByTheRest of `free_px2`. Never less than one of them needs.
float most_scale_px(double free_px2, const std::vector<Interval>& left);

/// What sizes are multiplied by in this attempt, counted from 0, to give each shape a place. The same bits everywhere.
float size_of_attempt(int attempt);

/// By what the sizes have to be multiplied so that the shapes fill this part of the area.
double size_factor(double area_px2, double part, const std::vector<Interval>& shapes);

}  // namespace tessera
