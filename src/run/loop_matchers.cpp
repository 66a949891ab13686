#include "run/loop_matchers.h"

#include <unistd.h>

#include <string>

#include "comm/teams/replacer_team.h"
#include "comm/teams/worker_team.h"
#include "core/base/rank_pool.h"
#include "core/matching/matching_context.h"
#include "core/matching/model_source.h"
#include "core/ranks/partition.h"
#include "core/replacing/own_replacer.h"
#include "files/library_abort.h"
#include "library/storage/shape_models.h"
#include "worker/device_group.h"

namespace tessera {
namespace {

MatchingContext context_of(const CollageProblem& problem) {
  return make_matching_context(problem.settings(), std::uint32_t(problem.library().size()));
}

/// Matching's needs of a device. The size of the canvas is the job's, whatever the canvas file shows.
worker::DeviceNeeds needs_of(const Job& job, const ModelSource& models) {
  return {.reads_models = models.supports_random_access(),
          .field_nodes = double(job.canvas.width_px) * job.canvas.height_px};
}

std::string host_name() {
  char name[256] = "";
  gethostname(name, sizeof name - 1);
  return name;
}

}  // namespace

LoopMatchers gather_matchers(comm::Communicator& ranks, const CollageProblem& problem, ShapeSource& shapes,
                             const StopQuestion& shall_stop) {
  if (ranks.size() > 1) {
    return {
        .matcher = comm::gather_workers(ranks), .replacer = comm::gather_replacers(ranks), .site = {host_name(), {}}};
  }
  const ShapeRange all = even_range(problem.library().size(), 0, 1);
  const worker::DeviceShare whole_node{.per_worker = problem.job().devices_per_worker};
  return own_matchers(problem, shapes, all, whole_node, stop_check(shall_stop));
}

LoopMatchers own_matchers(const CollageProblem& problem, ShapeSource& shapes, const ShapeRange& part,
                          const worker::DeviceShare& share, const StopCheck& check_stop) {
  const Job& job = problem.job();
  const MatchingContext context = context_of(problem);
  const auto models = models_of(problem.library(), context);
  const std::vector<worker::DevicePart> parts =
      worker::device_parts(job.devices, context, part, needs_of(job, *models), share, check_stop);
  set_abort_handler_again();  // on a rank without workers; under MPI no LibraryAbortHandler lives, and nothing is taken
  return {.matcher = worker::make_device_matcher(parts, context, models, check_stop),
          .replacer = std::make_unique<OwnReplacer>(shapes, rank_pool(), check_stop),
          .site = {host_name(), worker::describe(parts)}};
}

void compile_kernels(const CollageProblem& problem) {
  worker::compile_kernels(problem.job().devices, context_of(problem));
}

}  // namespace tessera
