// The output of `tessera plan`: a table of estimates, and the head of a batch script that fits them.
#pragma once

#include <string>

#include "plan/plan_estimate.h"

namespace tessera {

/// The estimates as a table for people, with a note on what they leave out.
std::string plan_text(const PlanInput& input, const PlanEstimate& plan);

/// A warning where more workers are planned than there are shapes; otherwise empty.
std::string idle_workers_warning(const PlanInput& input, const PlanEstimate& plan);

/// The #SBATCH lines. They ask for a quarter more memory and three times the time that is estimated.
std::string sbatch_header(const PlanInput& input, const PlanEstimate& plan);

/// Slurm's form of a time: 5400 -> "01:30:00".
std::string slurm_time(double seconds);

}  // namespace tessera
