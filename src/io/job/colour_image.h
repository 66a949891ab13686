// colour.image: the picture that the pieces are to show together.
#pragma once

#include <memory>

#include "core/colour/colour_target.h"
#include "core/field/canvas.h"
#include "io/job/job_file.h"
#include "io/library/shape_library.h"

namespace tessera::io {

/// Makes the job's colours those of its picture, which is laid over the whole canvas, its middle on the canvas' middle;
/// nothing where the job names none. Throws InputError that names the key and the file: where that is no picture or
/// transparent all over, where the canvas is seamless, where the library does not know the colours of its drawings'
/// parts (it is older).
void set_colours(const Canvas& canvas, const ShapeLibrary& library, Job& job);

/// The same from a target that is there already.
void set_colours(std::shared_ptr<const ColourTarget> target, const ShapeLibrary& library, Job& job);

}  // namespace tessera::io
