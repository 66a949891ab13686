// Chooses the pieces of a result that shall be removed: by number, in a rectangle, or under a scribble.
#pragma once

#include <string>
#include <vector>

#include "job/job_file.h"
#include "result/placed_pieces.h"

namespace tessera::cli {

/// Exactly one of them is given.
struct EraseArguments {
  std::vector<int> pieces;    // numbers, `index` of pieces.geojson
  std::vector<int> swapped;   // numbers, too; other drawings shall replace these
  std::vector<float> box_px;  // x, y, width, height
  std::string mask;           // a picture file with the scribble

  bool any() const { return !pieces.empty() || !swapped.empty() || !box_px.empty() || !mask.empty(); }
};

/// Indices of the chosen pieces, ascending. Locked pieces in a rectangle or under a scribble are left out; at least one
/// piece remains. `folder`: of the result; `job`: the job that will run. Throws InputError that names the option, what
/// was found and what is allowed.
std::vector<int> erased_pieces(const EraseArguments& arguments, const std::string& folder, const Job& job,
                               const std::vector<PlacedPiece>& all);

/// The numbers in ascending order, each once. Throws InputError where one of them is not below `count`.
std::vector<int> piece_numbers(const std::string& option, std::vector<int> pieces, std::size_t count);

}  // namespace tessera::cli
