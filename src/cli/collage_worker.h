// The ranks of tessera collage that search the library: a part of it each, on the devices of their node.
#pragma once

#include <memory>

#include "comm/communicator.h"
#include "core/matching/matcher.h"
#include "io/job/job_file.h"
#include "io/library/library_file.h"

namespace tessera::cli {

/// A worker's life, from the master's job on. Leaves by JobEnded; throws InputError and EnvironmentError.
[[noreturn]] void run_collage_worker(comm::Communicator& ranks);

/// On rank 0, for the workers: what they are to do.
void send_job(comm::Communicator& ranks, const io::Job& job);

/// For a run without workers: the whole library on this rank's devices.
std::unique_ptr<Matcher> own_matcher(const io::Job& job, const io::LibraryFile& library);

}  // namespace tessera::cli
