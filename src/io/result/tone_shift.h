// colour.shift: the tones of pieces, shifted towards the picture that they show together.
#pragma once

#include <cstddef>
#include <opencv2/core/matx.hpp>
#include <string>
#include <vector>

#include "core/colour/colour_target.h"
#include "io/result/collage_files.h"

namespace tessera::io {

/// The mean colour of the picture beneath each piece, "#rrggbb"; "" where it wishes nothing. The shapes have their
/// outlines.
std::vector<std::string> covered_colours(const CollageReport& report, const ColourTarget& target);

/// A piece's mean colour before tones are shifted: that of its drawing, or of its silhouette in a palette.
cv::Vec3b drawn_colour(const CollageReport& report, std::size_t piece);

/// For each piece what goes to CollageReport::tones: from its mean colour towards that of what it covers
/// (CollageReport::covered), as far as `most_difference` (CIEDE2000) allows. Empty where that is 0.
std::vector<ToneShift> tone_shifts(const CollageReport& report, double most_difference);

}  // namespace tessera::io
