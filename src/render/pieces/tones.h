// colour.shift: brings the tones of pieces nearer to the picture that they show together.
#pragma once

#include <cstddef>
#include <opencv2/core.hpp>
#include <string>
#include <vector>

#include "core/colour/colour_target.h"
#include "render/pieces/drawn_colours.h"
#include "result/collage_files.h"

namespace tessera {

/// The mean colour of the picture beneath each piece, "#rrggbb"; "" where the picture has no wish. The shapes must have
/// their outlines.
std::vector<std::string> covered_colours(const std::vector<Placement>& placements, const PlacedShapes& shapes,
                                         const ColourTarget& target);

/// A piece's mean colour before tones are shifted: of its drawing, or of its silhouette in a palette.
cv::Vec3b drawn_colour(const CollageReport& report, std::size_t piece);

/// The tone of each piece (CollageReport::tones): each cell of its colours is moved towards the picture beneath it, as far
/// as `most_difference` (CIEDE2000) allows. `drawn`: colours of the shapes, by slot. `shown_bgra`: the picture over the
/// canvas (shown_picture.h), straight alpha; where it is empty, as in results of older versions, the mean beneath the piece
/// is used (CollageReport::covered). Empty where `most_difference` is 0 or no picture is shown.
std::vector<Tone> tones_towards_picture(const CollageReport& report, const std::vector<DrawnColours>& drawn,
                                        const cv::Mat& shown_bgra, double most_difference);

}  // namespace tessera
