// tessera rank, after its arguments are read. tessera campaign ends with it, too.
#pragma once

#include <string>
#include <vector>

namespace tessera {

struct RankingArguments {
  std::vector<std::string> folders;  // results, or folders of results
  std::string out;                   // folder of the ranking's files; empty: the only one of `folders`
  std::vector<std::string> weights;  // "NAME=WEIGHT"
};

/// Throws EnvironmentError where a ranking's files could not be written into this existing folder.
void check_ranking_can_be_written(const std::string& folder);

/// Prints the table and writes the files. Throws InputError and EnvironmentError.
int run_ranking(const RankingArguments& arguments);

}  // namespace tessera
