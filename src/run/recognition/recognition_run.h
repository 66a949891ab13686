// tessera recognize, after its arguments are read: from the files of the queries to a table, JSON and a sheet.
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
  double least_score = 0.4;     // RecognisedShape::score of the best shape; below it the query is unknown
  std::optional<double> scale;  // px of the query for one px of the library's drawings
  std::string json;             // empty: none
  std::string sheet;            // PNG; empty: none
  bool quiet = false;
};

/// Runs on every rank; the exit code is rank 0's: kIncompleteExitCode where a query is nothing that the library has.
/// Throws InputError, EnvironmentError.
int recognize_on_all_ranks(const RecognizeArguments& arguments, comm::Communicator& ranks);

}  // namespace tessera
