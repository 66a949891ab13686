// A layout in words and numbers: its places in JSON, and a card.
#pragma once

#include <string>

#include "core/base/stop.h"
#include "products/nesting/layout/nest_problem.h"
#include "products/nesting/nest_input.h"

namespace tessera {

struct NestRun {
  NestInput input;      // its sources are the problem's items
  NestProblem problem;  // mm
  NestLayout layout;
  std::string effort;
  std::uint64_t seed = 1;
  double seconds = 0;
  std::optional<StopReason> stopped_by;  // before all of the search was done
};

/// What layout.json and card.txt begin with, so that a folder of tessera nest can be told from others.
inline constexpr const char* kNestProgram = "tessera nest";
inline constexpr const char* kNestLayoutName = "layout.json";
inline constexpr const char* kNestCardName = "card.txt";

/// Area of the pieces over that of the strip as far as it is used, or of all sheets.
double density_of(const NestRun& run);

/// How many pieces were wanted.
int wanted_pieces(const NestRun& run);

/// What ended the search of a run that was stopped, for people: "the time limit".
std::string stopped_by_text(const NestRun& run);

/// layout.json, in the manner of sparrow's solutions: rotation in degrees about the shape's own origin, then the
/// translation.
std::string nest_layout_json(const NestRun& run);

/// card.txt.
std::string nest_card_text(const NestRun& run);

}  // namespace tessera
