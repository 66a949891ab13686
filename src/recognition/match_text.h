// Matches as a table for people and as JSON.
#pragma once

#include <string>
#include <vector>

#include "core/recognition/curve_match.h"

namespace tessera {

/// A line for each match: score, similarity, matched parts, number of runs, and the pose of B: scale, rotation (degrees,
/// clockwise on the picture) and the place of B's origin, in units of A.
std::string match_table(const std::vector<CurveMatch>& matches);

/// JSON with the same figures and the runs. Runs are arclengths from each curve's first point, in units of its own drawing.
/// Lines end with line ends.
std::string match_json(const std::string& path_a, const std::string& path_b, const std::vector<CurveMatch>& matches);

}  // namespace tessera
