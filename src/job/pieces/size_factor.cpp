#include "job/pieces/size_factor.h"

#include "core/matching/sized_settings.h"
#include "job/pieces/job_library.h"

namespace tessera {

double size_factor_on(const Canvas& canvas, const ShapeLibrary& library, const CollageSettings& settings) {
  if (!settings.pieces.fit_all) return 1;
  return first_size_factor(settings, std::uint32_t(library.size()), canvas.area_px2, library.drawings());
}

float smallest_size_px(const Canvas& canvas, const LibraryView& library, Job job) {
  resolve_wishes(library, job);
  if (job.settings.pieces.fit_all) add_start_pieces(library, job);
  return with_sizes_times(size_factor_on(canvas, library, job.settings), job.settings).pieces.min_scale_px;
}

}  // namespace tessera
