// Before the first round every worker compares its program, its job and its library with the master's. Where they differ,
// the run would end normally and give another collage, or none.
#pragma once

#include <cstdint>
#include <string>

#include "comm/communicator.h"
#include "job/job_file.h"
#include "run/collage_problem.h"

namespace tessera {

/// Called by rank 0: sends the master's program and problem to all workers. `library_digest`: digest of its library's content,
/// which the caller knows already, because computing it takes time.
void announce_problem(comm::Communicator& ranks, const std::string& program, const CollageProblem& problem,
                      std::uint64_t library_digest);

/// Called first by a worker: receives the master's job. Throws EnvironmentError where this rank's program differs or reads the
/// job in another way.
Job receive_job(comm::Communicator& ranks, const std::string& program);

/// Called second by a worker: makes the problem of that job, with what the master found on the canvas. Throws InputError where
/// this rank's library has other content than the master's, or other colours of its drawings.
CollageProblem receive_problem(comm::Communicator& ranks, Job job);

/// The part of announce_problem() that receive_job() answers.
void announce_job(comm::Communicator& ranks, const std::string& program, const Job& job);

}  // namespace tessera
