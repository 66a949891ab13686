// Draws matches: both sets of curves, with matching parts in the same colour, and B laid onto A.
#pragma once

#include <string>
#include <vector>

#include "core/recognition/curve_match.h"

namespace tessera {

/// An SVG with a row for each match.
std::string match_picture(const std::vector<Curve>& a, const std::vector<Curve>& b,
                          const std::vector<CurveMatch>& matches);

}  // namespace tessera
