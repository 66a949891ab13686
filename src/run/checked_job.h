// The files that a job names, read and checked before anything costs time: tessera collage and tessera plan tell the same
// mistakes. All throw InputError that names the file or key, what was found and what is allowed.
#pragma once

#include "core/field/canvas.h"
#include "job/job_file.h"
#include "library/library_view.h"

namespace tessera {

/// The shapes that the job chooses. By their names the job's wishes are resolved, and the pieces that it starts from added.
LibraryView checked_library(Job& job);

/// The canvas, of the job from checked_library. The factor of the sizes, which goes by its area, is set in the job.
Canvas checked_canvas(const ShapeLibrary& library, Job& job);

/// Adds to the job's wishes that no piece of start.remove comes back to where it lay, unless nothing else may come in
/// for it. This goes by the whole canvas, so that it is called before limit_to_room().
void keep_removed_from_coming_back(const ShapeLibrary& library, const Canvas& canvas, Job& job);

/// Where pieces are removed (start.remove) only their room is filled, and as far round it as a gap may be that nothing
/// fits into. Returns which part of the canvas that is.
double limit_to_room(const ShapeLibrary& library, const Job& job, Canvas& canvas);

}  // namespace tessera
