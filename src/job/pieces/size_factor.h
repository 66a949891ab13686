// The effect of pieces.fit = "all" on the sizes of a job on its canvas.
#pragma once

#include "core/field/canvas.h"
#include "core/settings/settings.h"
#include "job/job_file.h"
#include "library/library_view.h"

namespace tessera {

/// The factor on all sizes in the first attempt of a collage; 1 where the job gives the sizes. `settings` must have
/// resolved wishes and the pieces that the collage starts from.
double size_factor_on(const Canvas& canvas, const ShapeLibrary& library, const CollageSettings& settings);

/// The size of the smallest piece in that attempt, px. The wishes of `job` are not resolved yet; the file that it
/// starts from is read where it matters. Throws InputError as open_library_of and add_start_pieces do.
float smallest_size_px(const Canvas& canvas, const LibraryView& library, Job job);

}  // namespace tessera
