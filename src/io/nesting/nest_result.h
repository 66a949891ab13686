// What nesting leaves behind: pictures for people and cutters, the places in JSON, a card, and jobs of a library's shapes.
#pragma once

#include <string>

#include "core/nesting/nest_problem.h"
#include "io/nesting/nest_input.h"

namespace tessera::io {

struct NestRun {
  NestInput input;      // its sources are the problem's items
  NestProblem problem;  // mm
  NestLayout layout;
  std::string effort;
  std::uint64_t seed = 1;
  double seconds = 0;
};

/// Area of the pieces over that of the strip as far as it is used, or of all sheets.
double density_of(const NestRun& run);

/// How many pieces were wanted.
int wanted_pieces(const NestRun& run);

/// Throws InputError where the folder holds something that is not of tessera nest; to be called before time is spent.
void check_nest_folder(const std::string& folder);

/// layout.json, card.txt, and of each sheet layout.svg, .dxf and .png; of a library's shapes layout.toml and
/// layout_pieces.geojson, too. Of several sheets they are called layout_1.svg and so on. What is there of an earlier run is
/// replaced, other files stay; while layout.json is missing the rest is not complete. Returns the card. Throws EnvironmentError.
std::string write_nest_result(const NestRun& run, const std::string& folder);

}  // namespace tessera::io
