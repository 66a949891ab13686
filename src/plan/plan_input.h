// The input of the estimates, taken from the problem that the ranks of a run would share.
#pragma once

#include "plan/plan_estimate.h"
#include "run/collage_problem.h"

namespace tessera {

struct PlanRanks {
  int ranks = 3;
  int nodes = 1;
};

PlanInput plan_input(const CanvasProblem& problem, PlanRanks on);

}  // namespace tessera
