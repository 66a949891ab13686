#include "cli/collage_worker.h"

#include <string>

#include "cli/library_part.h"
#include "comm/matcher_server.h"
#include "comm/node_turn.h"
#include "core/matching/matching_context.h"
#include "io/available_cores.h"
#include "io/job/job_library.h"
#include "io/library/shape_models.h"
#include "worker/device_group.h"

namespace tessera::cli {
namespace {

MatchingContext context_of(const io::Job& job, const io::LibraryFile& library) {
  return make_matching_context(job.settings, std::uint32_t(library.size()));
}

io::Job received_job(comm::Communicator& ranks) {
  const comm::Bytes bytes = ranks.broadcast({});
  return io::job_from_toml(std::string(bytes.begin(), bytes.end()), "the master's job");
}

/// A worker's devices share its node with those of the other workers.
worker::DeviceShare share_node(const comm::Communicator& ranks, const io::Job& job) {
  const bool with_master = ranks.node_ranks().front() == 0;
  const int workers = ranks.local_size() - with_master;
  worker::limit_cpu_threads(io::available_cores() / workers);
  return {ranks.local_rank() - with_master, workers, job.devices_per_worker};
}

}  // namespace

void run_collage_worker(comm::Communicator& ranks) {
  const io::Job job = received_job(ranks);
  const io::LibraryFile library = io::open_library_of(job);
  const ShapeRange part = library_part(library.size(), ranks.rank() - 1, ranks.size() - 1);
  const MatchingContext context = context_of(job, library);
  const worker::DeviceShare share = share_node(ranks, job);
  comm::first_worker_of_node_first(ranks, [&] { worker::compile_kernels(job.devices, context); });
  comm::serve(ranks, worker::make_device_matcher(job.devices, context, part, io::models_of(library, context), share));
}

void send_job(comm::Communicator& ranks, const io::Job& job) {
  const std::string text = io::to_toml(job);
  ranks.broadcast({text.begin(), text.end()});
}

std::unique_ptr<Matcher> own_matcher(const io::Job& job, const io::LibraryFile& library) {
  const MatchingContext context = context_of(job, library);
  const ShapeRange all = library_part(library.size(), 0, 1);
  return worker::make_device_matcher(job.devices, context, all, io::models_of(library, context),
                                     {.per_worker = job.devices_per_worker});
}

}  // namespace tessera::cli
