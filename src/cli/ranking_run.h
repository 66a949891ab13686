// tessera rank, after its arguments are read; tessera campaign ends with it too.
#pragma once

#include <string>
#include <vector>

namespace tessera::cli {

struct RankingArguments {
  std::vector<std::string> folders;  // results, or folders of results
  std::string out;                   // for the ranking's files; empty = the folder where it is the only one
  std::vector<std::string> weights;  // "NAME=WEIGHT"
};

/// Prints the table and writes the files. Throws InputError and EnvironmentError.
int run_ranking(const RankingArguments& arguments);

}  // namespace tessera::cli
