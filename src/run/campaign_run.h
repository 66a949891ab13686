// tessera campaign, after its arguments are read: runs one collage after the other, then ranks them.
#pragma once

#include <string>
#include <vector>

#include "comm/communicator.h"

namespace tessera {

struct CampaignArguments {
  std::string job;                   // the file
  std::string out;                   // the folder of all results; empty: out/<name of the job file>-campaign
  std::string seeds;                 // "1-8,12"; empty: the seed of the job
  std::vector<std::string> sets;     // "section.key=value,value"
  std::vector<std::string> weights;  // weights of the ranking, "NAME=WEIGHT"
  bool list = false;                 // only list the collages
};

/// Runs the campaign; there is one rank. Results that are there already are not made again. Returns the exit code. Throws
/// InputError and EnvironmentError.
int run_campaign(const CampaignArguments& arguments, comm::Communicator& ranks);

}  // namespace tessera
