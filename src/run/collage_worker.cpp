#include "run/collage_worker.h"

#include <memory>
#include <utility>

#include "comm/heartbeat.h"
#include "comm/teams/node_turn.h"
#include "comm/teams/rank_sites.h"
#include "comm/teams/worker_server.h"
#include "core/base/rank_pool.h"
#include "core/base/stop.h"
#include "core/ranks/partition.h"
#include "core/replacing/own_replacer.h"
#include "library/library_shapes.h"
#include "library/storage/shape_models.h"
#include "run/collage_engine.h"
#include "run/problem_exchange.h"
#include "run/program_identity.h"
#include "worker/device_group.h"

namespace tessera {
namespace {

/// A worker's devices and cores are its part of its node's, shared with the other workers there.
worker::DeviceShare share_of_node(const comm::Communicator& ranks, const Job& job) {
  const bool with_master = ranks.node_ranks().front() == 0;
  return {ranks.local_rank() - with_master, ranks.local_size() - with_master, job.devices_per_worker};
}

}  // namespace

void run_collage_worker(comm::Communicator& ranks) {
  Job masters = receive_job(ranks, program_identity());
  const comm::Heart heart(ranks, masters.comm.silence_s);
  const CollageProblem problem = receive_problem(ranks, std::move(masters));
  const Job& job = problem.job();
  const LibraryView& library = problem.library();
  const ShapeRange part = even_range(library.size(), ranks.rank() - 1, ranks.size() - 1);
  const MatchingContext context = context_of(problem);
  const worker::DeviceShare share = share_of_node(ranks, job);
  share_cores(share.workers);
  worker::limit_cpu_threads(rank_cores());
  comm::first_worker_of_node_first(ranks, [&] { worker::compile_kernels(job.devices, context); });
  const StopCheck check_stop = [&ranks] { ranks.look(); };
  const auto models = models_of(library, context);
  const std::vector<worker::DevicePart> parts =
      worker::device_parts(job.devices, context, part, needs_of(job, *models), share, check_stop);
  comm::tell_site(ranks, {host_name(), worker::describe(parts)});
  LibraryShapes shapes(library);
  comm::serve(ranks, worker::make_device_matcher(parts, context, models, check_stop),
              std::make_unique<OwnReplacer>(shapes, rank_pool(), check_stop));
}

}  // namespace tessera
