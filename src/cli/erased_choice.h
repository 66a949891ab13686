// Which pieces of a result are to go: by number, in a rectangle, or under a scribble.
#pragma once

#include <string>
#include <vector>

#include "job/job_file.h"
#include "result/placed_pieces.h"

namespace tessera::cli {

/// One of them is given.
struct EraseArguments {
  std::vector<int> pieces;    // by `index` of pieces.geojson
  std::vector<int> swapped;   // likewise; others are to come in
  std::vector<float> box_px;  // x, y, width, height
  std::string mask;           // a file

  bool any() const { return !pieces.empty() || !swapped.empty() || !box_px.empty() || !mask.empty(); }
};

/// Places of pieces, ascending, one at least and none that is locked: those in a rectangle or under a scribble stay.
/// `folder`: of the result; `job`: the one that is to be run.
/// Throws InputError that names the option, what was found and what is allowed.
std::vector<int> erased_pieces(const EraseArguments& arguments, const std::string& folder, const Job& job,
                               const std::vector<PlacedPiece>& all);

/// Ascending, each once. Throws InputError where one is none of `count` pieces.
std::vector<int> piece_numbers(const std::string& option, std::vector<int> pieces, std::size_t count);

}  // namespace tessera::cli
