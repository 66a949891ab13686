// Writes a layout in words and numbers: its places in JSON, and a card.
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
  std::optional<StopReason> stopped_by;  // set where the search did not end by itself
};

/// The beginning of layout.json and card.txt, by which folders of tessera nest are recognised.
inline constexpr const char* kNestProgram = "tessera nest";
inline constexpr const char* kNestLayoutName = "layout.json";
inline constexpr const char* kNestCardName = "card.txt";

/// The area of the pieces divided by the used area of the strip, or by that of all sheets.
double density_of(const NestRun& run);

/// The number of pieces that were wanted.
int wanted_pieces(const NestRun& run);

/// The reason why the search of a run was stopped, for people: "the time limit".
std::string stopped_by_text(const NestRun& run);

/// The text of layout.json, in the format of sparrow's solutions: rotation in degrees about the shape's own origin, then
/// the translation.
std::string nest_layout_json(const NestRun& run);

/// The text of card.txt.
std::string nest_card_text(const NestRun& run);

}  // namespace tessera
