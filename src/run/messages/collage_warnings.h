// What tessera collage says on stderr, --quiet or not, where it does as it was told and somebody may be sorry.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "core/field/canvas.h"
#include "core/shape/shape.h"
#include "job/job_file.h"
#include "master/collage_loop.h"
#include "result/folder/finished_result.h"
#include "run/messages/written_keys.h"

namespace tessera {

/// Empty where the folder holds no result, an unfinished one, or the finished one of the same job.
std::string replaced_result_warning(const EarlierResult& earlier, const Job& job);

/// The key of [stop] that ended the run; empty where none did.
std::string limit_that_ended(const RunStatistics& run);

/// Empty where there are pieces, or where the run may still go on to some. `what_to_try` lets pieces in
/// (place_advice.h); empty where no shape may stand at all.
std::string empty_result_warning(const std::string& folder, const WrittenKeys& keys,
                                 const master::CollageResult& result, const std::vector<std::string>& what_to_try);

/// The warning that names the pieces which a finished result lacks. Empty where it lacks none.
std::string incomplete_warning(const std::string& folder, const ResultManifest& manifest);

/// Which of the pieces that stand from the start lie in zones that are kept out of; and of those of start.pieces, which
/// lie outside the canvas or on others. Empty where all lie well. The first `rows` of the given pieces are those of
/// [[given]]. `shape(id)` gives library shapes with their outlines.
std::string standing_warning(const CollageSettings& settings, std::size_t rows, const Canvas& canvas,
                             const std::function<const Shape&(ShapeId)>& shape);

/// Where the library was used up with much of the canvas left: the sizes that would fill it; with drawn sizes
/// (has_drawn_sizes), which no key multiplies, what finds such sizes. Else empty, as where the program found the sizes
/// itself.
std::string used_up_warning(const PieceSettings& pieces, bool drawn_sizes, const Canvas& canvas,
                            const master::CollageResult& result);

/// Of keys that were given and mean nothing beside others, or without them: output.dpi, pieces.overlap_px,
/// pieces.least_scale_px, library.colours_within, colour.weight, colour.shift. The warnings of idle keys are about a
/// job's file, not about what comes of it: hence the whole job.
std::string idle_keys_warning(const Job& job);

/// Where an output.dpi is given, and the pictures have no size in mm. Empty where they have.
std::string idle_dpi_warning(const Job& job);
/// Where a colour.shift is given, and no picture to shift to.
std::string idle_shift_warning(const Job& job);
/// The same of output.background_light.
std::string idle_light_warning(const Job& job);

/// Where scale_px or rotation_deg of [pieces] or of a row of [[shapes]] is a list of three numbers or more that does not rise: 30,5 may have
/// been meant as 30.5.
std::string decimal_comma_warning(const Job& job);

/// Where the pieces are to show an image and will not: `one_colour`, nearly all shapes are of the same colour and drawn
/// in it; or they are few.
std::string unable_library_warning(const ColourSpec& colour, std::size_t shapes, bool one_colour);

/// Where canvas.file, or the file of canvas.keep_out, draws an outline alone (job/canvas/canvas_enclosure.h): only its line
/// counts. Empty else, and where regions are told by their colours.
std::string outline_alone_warning(const CanvasSpec& spec, const Canvas& canvas);

/// Where pieces are to be relaxed and will not: why. Empty where they will.
std::string idle_relaxing_warning(const CollageSettings& settings);

/// Where none of the trials that were to relax covered more. Empty where pieces were not relaxed at all: that was told.
std::string nothing_gained_warning(const CollageSettings& settings, const master::CollageResult& result);

/// Where pieces were removed, so many, and none came in for them beside the `given` ones. Empty else, and where the run
/// may still go on.
std::string empty_room_warning(std::size_t removed, std::size_t given, const master::CollageResult& result);

/// Says how many of the `removed` pieces came back to where they lay, as nothing else may come in for them. Empty where
/// none did, and where the run may still go on. The first `given` pieces are no new ones. `silhouettes`: for each shape
/// of the library the first one that looks like it.
std::string come_back_warning(const std::vector<GivenPiece>& removed, std::size_t given, const Canvas& canvas,
                              const master::CollageResult& result, const std::vector<std::uint32_t>& silhouettes);

/// Those that say something, with semicolons between them.
std::string joined_warnings(const std::vector<std::string>& warnings);

}  // namespace tessera
