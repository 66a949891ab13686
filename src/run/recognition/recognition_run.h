// tessera recognize, after its arguments are read: reads the queries and makes a table, JSON and a sheet.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "comm/communicator.h"

namespace tessera {

struct RecognizeArguments {
  std::vector<std::string> queries;  // files
  std::string library;
  std::size_t most = 10;
  double least_score = 0.4;     // score (RecognisedShape) that the best shape needs; below it the query is unknown
  std::optional<double> scale;  // px of the query for one px of the library's drawings
  std::string json;             // empty: none
  std::string sheet;            // PNG; empty: none
  bool quiet = false;
};

/// Runs on every rank and returns rank 0's exit code: kIncompleteExitCode where a query is not in the library. Throws
/// InputError, EnvironmentError.
int recognize_on_all_ranks(const RecognizeArguments& arguments, comm::Communicator& ranks);

}  // namespace tessera
