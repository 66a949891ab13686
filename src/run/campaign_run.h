// tessera campaign, after its arguments are read: one collage after the other, then the ranking.
#pragma once

#include <string>
#include <vector>

#include "comm/communicator.h"

namespace tessera {

struct CampaignArguments {
  std::string job;                   // the file
  std::string out;                   // the folder of all results; empty = out/<name of the job file>-campaign
  std::string seeds;                 // "1-8,12"; empty = the job's
  std::vector<std::string> sets;     // "section.key=value,value"
  std::vector<std::string> weights;  // of the ranking, "NAME=WEIGHT"
  bool list = false;                 // only say what there is to do
};

/// One rank. Results that are there already are not made again. Returns the exit code; throws InputError and
/// EnvironmentError.
int run_campaign(const CampaignArguments& arguments, comm::Communicator& ranks);

}  // namespace tessera
