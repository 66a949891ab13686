#include "run/collage_worker.h"

#include <utility>

#include "comm/heartbeat.h"
#include "comm/teams/node_turn.h"
#include "comm/teams/rank_sites.h"
#include "comm/teams/worker_server.h"
#include "core/base/rank_pool.h"
#include "core/ranks/partition.h"
#include "library/library_shapes.h"
#include "run/loop_matchers.h"
#include "run/problem_exchange.h"
#include "run/program_identity.h"
#include "worker/device_group.h"

namespace tessera {
namespace {

/// This worker's share of its node's devices and cores, which it shares with the node's other workers.
worker::DeviceShare share_of_node(const comm::Communicator& ranks, const Job& job) {
  const bool with_master = ranks.node_ranks().front() == 0;
  return {ranks.local_rank() - with_master, ranks.local_size() - with_master, job.devices_per_worker};
}

}  // namespace

void run_collage_worker(comm::Communicator& ranks) {
  Job masters = receive_job(ranks, program_identity());
  const comm::HeartbeatSender heart(ranks, masters.comm.silence_s);
  const CollageProblem problem = receive_problem(ranks, std::move(masters));
  const worker::DeviceShare share = share_of_node(ranks, problem.job());
  share_cores(share.workers);
  worker::limit_cpu_threads(rank_cores());
  comm::first_worker_of_node_first(ranks, [&] { compile_kernels(problem); });
  LibraryShapes shapes(problem.library());
  const ShapeRange part = even_range(problem.library().size(), ranks.rank() - 1, ranks.size() - 1);
  LoopMatchers own = own_matchers(problem, shapes, part, share, [&ranks] { ranks.check_arrivals(); });
  comm::tell_site(ranks, own.site);
  comm::serve(ranks, std::move(own.matcher), std::move(own.replacer));
}

}  // namespace tessera
