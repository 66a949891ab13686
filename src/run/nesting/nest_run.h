// tessera nest, after its arguments are read: makes the files of a layout from the drawings.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "comm/communicator.h"

namespace tessera {

struct NestArguments {
  std::string input;
  std::optional<double> strip_mm;
  std::vector<double> sheet_mm;  // width, height; empty: a strip
  std::vector<double> angles_deg;
  std::vector<std::string> demands;   // "NAME=COUNT"
  std::vector<std::string> left_out;  // names of elements of an SVG that are not cut
  std::optional<double> px_per_inch;  // of SVGs; empty: 96
  double spacing_mm = 0;
  std::string effort = "good";
  std::uint64_t seed = 1;
  std::string folder;  // empty: out/<name of the input>
  bool quiet = false;
  std::optional<std::string> time_limit;
  double silence_s = 60;  // a rank that is silent for so long is lost; like comm.silence_s of a job
};

/// Rank 0 writes the layout, the others search with it. Returns the exit code (exit_codes.h). A time limit of the user ends
/// the search and counts as no interruption. Signals, the end of a Slurm job and a lost rank count as one; the best layout
/// so far is written all the same.
int nest_on_all_ranks(NestArguments arguments, comm::Communicator& ranks);

}  // namespace tessera
