// Makes a progress that only grows from the solving of a puzzle, although pieces are laid several times.
#pragma once

#include <cstddef>
#include <string>

#include "products/puzzle/laying/puzzle_solver.h"

namespace tessera {

/// Follows the solving of one puzzle.
class SolvingProgress {
 public:
  struct Shown {
    std::string label;  // of the bar: "matching" until pieces are laid, then "laying"
    std::size_t done = 0, of = 0;
    std::string note;  // the present step, and the number of the arrangement
  };

  /// `done` never falls while the label stays the same, and the label changes at most once.
  Shown see(const PuzzleProgress& at);

 private:
  bool laying_ = false;   // some pieces have been laid
  std::size_t most_ = 0;  // largest `done` so far, under this label
  std::size_t last_ = 0;  // laid pieces at the last call
  int arrangement_ = 1;   // number of the present arrangement
};

}  // namespace tessera
