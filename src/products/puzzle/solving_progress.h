// What is shown of how far a puzzle is: a number that only grows, though pieces are laid several times.
#pragma once

#include <cstddef>
#include <string>

#include "products/puzzle/laying/puzzle_solver.h"

namespace tessera {

/// Follows the solving of one puzzle.
class SolvingProgress {
 public:
  struct Shown {
    std::string label;  // of the bar: "matching" until pieces are laid, "laying" from then on
    std::size_t done = 0, of = 0;
    std::string note;  // what is being done now, and with which arrangement
  };

  /// `done` never falls while the label stays, and the label changes once at most.
  Shown see(const PuzzleProgress& at);

 private:
  bool laying_ = false;   // some pieces have been laid
  std::size_t most_ = 0;  // so far, under this label
  std::size_t last_ = 0;  // pieces that lay when it was told last
  int arrangement_ = 1;   // that is being laid
};

}  // namespace tessera
