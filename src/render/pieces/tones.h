// colour.shift: the tones of pieces, brought nearer to the picture that they show together.
#pragma once

#include <cstddef>
#include <opencv2/core.hpp>
#include <string>
#include <vector>

#include "core/colour/colour_target.h"
#include "render/pieces/drawn_colours.h"
#include "result/collage_files.h"

namespace tessera {

/// The mean colour of the picture beneath each piece, "#rrggbb"; "" where it wishes nothing. The shapes have their
/// outlines.
std::vector<std::string> covered_colours(const std::vector<Placement>& placements, const PlacedShapes& shapes,
                                         const ColourTarget& target);

/// A piece's mean colour before tones are shifted: that of its drawing, or of its silhouette in a palette.
cv::Vec3b drawn_colour(const CollageReport& report, std::size_t piece);

/// For each piece what goes to CollageReport::tones: each cell of its colours moved towards what lies beneath it, as
/// far as `most_difference` (CIEDE2000) allows. `drawn`: of the shapes, by slot. `shown_bgra` is the picture over the
/// canvas (shown_picture.h), straight alpha; where it is empty the piece's mean stands for it (CollageReport::covered),
/// as in results of older versions. Empty where `most_difference` is 0 or no picture is shown.
std::vector<Tone> tones_towards_picture(const CollageReport& report, const std::vector<DrawnColours>& drawn,
                                        const cv::Mat& shown_bgra, double most_difference);

}  // namespace tessera
