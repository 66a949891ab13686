// Before the first round: every worker compares what it runs, what it understood and what it read with the master's.
// Where they differ the run would end well and give another collage, or none.
#pragma once

#include <string>

#include "comm/communicator.h"
#include "job/job_file.h"
#include "library/storage/shape_library.h"

namespace tessera {

/// "tessera 0.1.0, commit 4554c24, kernels 5a0c1e4bd1f0a977"
std::string program_identity();

/// Rank 0: tells all workers the master's program, job and library.
void announce_run(comm::Communicator& ranks, const std::string& program, const Job& job, std::uint64_t library_digest);

/// A worker: receives the master's job. Throws EnvironmentError where this rank's program is another one or understands
/// the job otherwise.
Job receive_job(comm::Communicator& ranks, const std::string& program);

/// Rank 0, then: the pictures that lie over the canvas.
void announce_overlays(comm::Communicator& ranks, const Job& job);

/// A worker, after receive_job: throws InputError where `library` has another content than the master's.
void check_library(comm::Communicator& ranks, const ShapeLibrary& library);

/// A worker, after check_library: sets the job's overlays. Throws InputError where its library knows other colours of
/// its drawings than the master's.
void receive_overlays(comm::Communicator& ranks, const ShapeLibrary& library, Job& job);

}  // namespace tessera
