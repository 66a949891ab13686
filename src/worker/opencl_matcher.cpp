#include "worker/opencl_matcher.h"

namespace tessera::worker {

OpenCLMatcher::OpenCLMatcher(const cl::Device& device, const MatchingContext& context, const ShapeRange& shapes,
                             std::shared_ptr<const ModelSource> models, const BetweenLaunches& between_launches,
                             std::size_t stage_bytes, const HeldShapes& held, std::optional<DockingLanes> lanes)
    : library_(device, context, shapes, std::move(models), between_launches, held, lanes),
      pairs_(library_, stage_bytes),
      docking_(library_, pairs_, stage_bytes),
      refinement_(library_) {}

ShapeRange OpenCLMatcher::shapes() const {
  const MatchRecord& match = library_.match();
  return {match.first_shape, match.first_shape + match.shapes};
}

void OpenCLMatcher::limit(const StanceLimits& limits) {
  library_.limit(limits);
  pairs_.forget();
}

std::vector<SampleRecord> OpenCLMatcher::records_of(const std::vector<TargetSample>& samples) {
  std::vector<SampleRecord> records = make_sample_records(samples, library_.match(), library_.pad_levels());
  library_.colours().assign_lists(samples, records);
  return records;
}

void OpenCLMatcher::post_count(const CountRequest& request) {
  if (!request.samples.empty()) pairs_.set_samples(records_of(request.samples));
  pairs_.post_count(request.bins, request.segment_stride);
}

void OpenCLMatcher::post_dock(const DockRequest& request) { docking_.post(request, records_of(request.samples)); }

}  // namespace tessera::worker
