// Before the first round: every worker compares what it runs, what it understood and what it read with the master's.
// Where they differ the run would end well and give another collage, or none.
#pragma once

#include <cstdint>
#include <string>

#include "comm/communicator.h"
#include "job/job_file.h"
#include "run/collage_problem.h"

namespace tessera {

/// Rank 0: tells all workers the master's program and its problem. `library_digest`: of its library's content, known
/// already to the caller, as it takes time.
void announce_problem(comm::Communicator& ranks, const std::string& program, const CollageProblem& problem,
                      std::uint64_t library_digest);

/// A worker, first: the master's job. Throws EnvironmentError where this rank's program is another one or understands
/// the job otherwise.
Job receive_job(comm::Communicator& ranks, const std::string& program);

/// A worker, then: the problem of that job, with what the master found on the canvas. Throws InputError where this
/// rank's library has another content than the master's, or knows other colours of its drawings.
CollageProblem receive_problem(comm::Communicator& ranks, Job job);

/// The part of announce_problem that receive_job answers.
void announce_job(comm::Communicator& ranks, const std::string& program, const Job& job);

}  // namespace tessera
