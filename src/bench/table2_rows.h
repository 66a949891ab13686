// The paper's Table 2, as printed.
#pragma once

#include <span>
#include <string_view>

namespace tessera::bench {

struct Table2Row {
  std::string_view figure;
  int candidates;  // shapes of the library
  int pads_per_shape;
  int iterations;                    // pieces
  std::string_view docking_choices;  // as text: two of them have exponents that do not fit the other columns
  double pruned_percent;
  double total_min;
  int prune_percent;  // of the total time: pruning of docking choices,
  int dock_percent;   // distance field evaluation,
  int objective_percent;
  int merge_percent;
};

/// The rows in the paper's order.
std::span<const Table2Row> table2_rows();

}  // namespace tessera::bench
