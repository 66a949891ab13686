#include "run/collage_engine.h"

#include <unistd.h>

#include "comm/teams/replacer_team.h"
#include "comm/teams/worker_team.h"
#include "core/base/rank_pool.h"
#include "core/ranks/partition.h"
#include "core/replacing/own_replacer.h"
#include "files/foreign_end.h"
#include "library/storage/shape_models.h"

namespace tessera {
namespace {

/// The whole library on the devices of this rank, pieces on its cores.
CollageEngine own_engine(const CollageProblem& problem, ShapeSource& shapes, const StopCheck& check_stop) {
  const Job& job = problem.job();
  const LibraryView& library = problem.library();
  const MatchingContext context = context_of(problem);
  const ShapeRange all = even_range(library.size(), 0, 1);
  const auto models = models_of(library, context);
  const std::vector<worker::DevicePart> parts = worker::device_parts(
      job.devices, context, all, needs_of(job, *models), {.per_worker = job.devices_per_worker}, check_stop);
  take_abort_again();
  return {.matcher = worker::make_device_matcher(parts, context, models, check_stop),
          .replacer = std::make_unique<OwnReplacer>(shapes, rank_pool(), check_stop),
          .site = {host_name(), worker::describe(parts)}};
}

}  // namespace

CollageEngine engine_of(comm::Communicator& ranks, const CollageProblem& problem, ShapeSource& shapes,
                        const StopQuestion& shall_stop) {
  if (ranks.size() == 1) return own_engine(problem, shapes, stop_check(shall_stop));
  return {.matcher = comm::gather_workers(ranks), .replacer = comm::gather_replacers(ranks), .site = {host_name(), {}}};
}

MatchingContext context_of(const CollageProblem& problem) {
  return make_matching_context(problem.settings(), std::uint32_t(problem.library().size()));
}

worker::DeviceNeeds needs_of(const Job& job, const ModelSource& models) {
  return {.reads_models = models.reads_singly(), .field_nodes = double(job.canvas.width_px) * job.canvas.height_px};
}

std::string host_name() {
  char name[256] = "";
  gethostname(name, sizeof name - 1);
  return name;
}

}  // namespace tessera
