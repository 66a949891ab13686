// colour.harmony: the hues of pieces, turned into a harmonic template of the hue wheel of CIELAB's a and b.
#pragma once

#include <array>
#include <opencv2/core.hpp>
#include <string>

#include "result/collage_files.h"

namespace tessera {

/// How a piece's colours are turned: the matrix of SVG's hueRotate on sRGB as it is coded, rows and columns red, green,
/// blue. Greys stay grey; lightness stays within 4 of 100 in the mean over all colours.
std::array<std::array<double, 3>, 3> hue_rotation(int turn_deg);

/// `bgra`: premultiplied.
void turn_hues(cv::Mat& bgra, int turn_deg);

/// Finds the template (`wanted`: "auto" or its letter; "none": nothing is done) for the mean colours of the pieces as
/// `report` has them, tones included, and adds to `report.tones` the turns that bring these into it. Where all is grey
/// there is no harmony.
void harmonise(CollageReport& report, const std::string& wanted);

}  // namespace tessera
