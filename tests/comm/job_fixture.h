// Runs run_rank on each rank, with the master's part and the workers' part as functions.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "comm/rank_program.h"

namespace tessera::comm::test {

struct JobOutcome {
  RankResult result;
  std::vector<std::string> reported;  // the lines that rank 0 reports
};

/// Call it on every rank. `worker` may return, throw or serve.
inline JobOutcome run_job(Communicator& ranks, const std::function<int(Communicator&)>& master,
                          const std::function<void(Communicator&)>& worker) {
  JobOutcome outcome;
  RankProgram program;
  program.run = [&](Communicator& c) {
    if (c.rank() == 0) return master(c);
    worker(c);
    return 0;
  };
  program.report_error = [&](const std::string& line) { outcome.reported.push_back(line); };
  outcome.result = run_rank(ranks, program);
  return outcome;
}

}  // namespace tessera::comm::test
