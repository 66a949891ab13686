// colour.harmony: turns the hues of pieces into a harmonic template on the hue wheel of CIELAB's a and b.
#pragma once

#include <array>
#include <opencv2/core.hpp>
#include <string>

#include "result/collage_files.h"

namespace tessera {

/// The matrix that turns a piece's colours, the same as SVG's hueRotate on encoded sRGB; rows and columns are red, green,
/// blue. Greys stay grey. Lightness changes by less than 4 of 100 in the mean over all colours.
std::array<std::array<double, 3>, 3> hue_rotation(int turn_deg);

/// Turns the hues of premultiplied pixels.
void turn_hues(cv::Mat& bgra, int turn_deg);

/// Finds the template for the mean colours of the pieces, including the tones in `report`, and adds the turns that bring
/// them into it to `report.tones`. `wanted`: "auto", the letter of a template, or "none" (does nothing). Where all colours
/// are grey there is no harmony.
void harmonise(CollageReport& report, const std::string& wanted);

}  // namespace tessera
