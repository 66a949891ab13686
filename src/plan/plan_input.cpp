#include "plan/plan_input.h"

#include <opencv2/core.hpp>

#include "core/field/free_field.h"
#include "core/matching/matching_context.h"
#include "job/picture_size.h"

namespace tessera {

PlanInput plan_input(const CanvasProblem& problem, PlanRanks on) {
  const CollageSettings& settings = problem.settings();
  const LibraryView& library = problem.library();
  const Window nodes = free_field_grid(problem.canvas(), settings.pieces).nodes();
  const cv::Size picture_px = picture_size_px(problem.output(), problem.canvas());
  const MatchingContext context = make_matching_context(settings, std::uint32_t(library.size()));
  return {.settings = settings,
          .canvas_px2 = problem.found().room_part * problem.canvas().area_px2,
          .canvas_nodes = double(nodes.width()) * nodes.height(),
          .picture_px2 = double(picture_px.width) * picture_px.height,
          .shapes = library.size(),
          .drawings = library.drawings(),
          .reads = library.stored_models(context) != nullptr,
          .host_devices = problem.job().devices != "gpu",
          .ranks = on.ranks,
          .nodes = on.nodes};
}

}  // namespace tessera
