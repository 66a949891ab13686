#include "run/problem_exchange.h"

#include <utility>

#include "comm/encode.h"
#include "core/base/error.h"
#include "job/pieces/job_library.h"
#include "run/problem_message.h"
#include "run/program_identity.h"
#include "text/digest_text.h"

namespace tessera {
namespace {

void check_library(const ShapeLibrary& library, std::uint64_t masters_digest) {
  const std::uint64_t own = library.content_digest();
  if (own == masters_digest) return;
  throw InputError(library.path() + ": not the master's library of the same name (digest of its content " +
                   digest_text(own) + ", the master's " + digest_text(masters_digest) +
                   "); all ranks must read the same: copy it anew to every node, or keep it where all nodes see it");
}

/// Throws InputError where the colours differ. `masters_digest`: of the overlays, with the colours of the drawings.
void check_colours(const CollageProblem& problem, std::uint64_t masters_digest) {
  if (problem.job().overlay_digest == masters_digest) return;
  throw InputError(problem.library().path() +
                   ": its drawings have other colours than in the master's library of the same name; all "
                   "ranks must read the same: copy it anew to every node, or keep it where all nodes see it");
}

}  // namespace

void announce_job(comm::Communicator& ranks, const std::string& program, const Job& job) {
  announce_program(ranks, program);
  ranks.broadcast(comm::encode(to_toml(job)));
}

Job receive_job(comm::Communicator& ranks, const std::string& program) {
  check_program(ranks, program);
  const auto masters_job = comm::decode<std::string>(ranks.broadcast({}));
  Job job = job_from_toml(masters_job, "the master's job");
  if (to_toml(job) != masters_job) {
    throw EnvironmentError(
        "this rank reads the master's job differently than the master does; install the same program "
        "and the same libraries on every node");
  }
  return job;
}

void announce_problem(comm::Communicator& ranks, const std::string& program, const CollageProblem& problem,
                      std::uint64_t library_digest) {
  announce_job(ranks, program, problem.job());
  ranks.broadcast(comm::encode(ProblemMessage{library_digest, problem.job().overlay_digest, problem.found()}));
}

CollageProblem receive_problem(comm::Communicator& ranks, Job job) {
  LibraryView library = open_library_of(job);
  auto masters = comm::decode<ProblemMessage>(ranks.broadcast({}));
  check_library(library, masters.library_digest);
  resolve_wishes(library, job);
  CollageProblem problem(std::move(job), std::move(library), std::move(masters.found));
  check_colours(problem, masters.overlay_digest);
  return problem;
}

}  // namespace tessera
