// Warnings of tessera collage, written to stderr even with --quiet. They tell a user what may be unexpected although the
// job is valid. Each function returns an empty text where there is nothing to warn of.
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

/// Warns that the run replaces a finished result of another job, or a damaged one.
std::string replaced_result_warning(const EarlierResult& earlier, const Job& job);

/// The key of [stop] that ended the run; empty where none did.
std::string limit_that_ended(const RunStatistics& run);

/// Says why a finished collage is empty. `what_to_try`: changes that let pieces in (place_advice.h); empty where no shape
/// may stand at all.
std::string empty_result_warning(const std::string& folder, const WrittenKeys& keys,
                                 const master::CollageResult& result, const std::vector<std::string>& what_to_try);

/// The warning that names the pieces which a finished result lacks. Empty where it lacks none.
std::string incomplete_warning(const std::string& folder, const ResultManifest& manifest);

/// Names pieces that stand from the start and lie in zones; and pieces of start.pieces that lie outside the canvas or on
/// others; but not the latter where `keep` is standing, as commands write that for layouts that may overlap. The first
/// `rows` given pieces are those of [[given]]. `shape(id)` gives library shapes with their outlines.
std::string standing_warning(const CollageSettings& settings, std::size_t rows, StartKeep keep, const Canvas& canvas,
                             const std::function<const Shape&(ShapeId)>& shape);

/// Warns that the library was used up while much of the canvas is free, and names the sizes that would fill it. With drawn
/// sizes (has_drawn_sizes), which no key multiplies, it names pieces.fit = "all". Empty also where the program found the
/// sizes itself.
std::string used_up_warning(const PieceSettings& pieces, bool drawn_sizes, const Canvas& canvas,
                            const master::CollageResult& result);

/// Names keys that have no effect because of other keys, or without them: output.dpi, pieces.overlap_px,
/// pieces.least_scale_px, library.colours_within, colour.weight, colour.shift and others. It takes the whole job, because
/// it is about the job's file.
std::string idle_keys_warning(const Job& job);

/// Warns of output.dpi where the pictures have no size in mm.
std::string idle_dpi_warning(const Job& job);
/// Warns of colour.shift without a picture to shift to.
std::string idle_shift_warning(const Job& job);
/// Warns of output.background_light without a picture as background.
std::string idle_light_warning(const Job& job);

/// Warns of lists of three or more numbers that do not rise in scale_px or rotation_deg, of [pieces] or [[shapes]]:
/// somebody may have written 30,5 for 30.5.
std::string decimal_comma_warning(const Job& job);

/// Warns that a library can hardly show colour.image: nearly all of its shapes have one colour (`one_colour`) and are drawn
/// in it, or there are few shapes.
std::string unable_library_warning(const ColourSpec& colour, std::size_t shapes, bool one_colour);

/// Warns that the drawing of canvas.file or canvas.keep_out is only an outline, so that only its line counts
/// (job/canvas/canvas_enclosure.h). Empty where colours tell regions apart.
std::string outline_alone_warning(const CanvasSpec& spec, const Canvas& canvas);

/// Says why pieces are not relaxed although the user asked for it. Empty where they are.
std::string idle_relaxing_warning(const CollageSettings& settings);

/// Warns that none of the trials that should relax lowered the loss. Empty where pieces were not relaxed at all.
std::string nothing_gained_warning(const CollageSettings& settings, const master::CollageResult& result);

/// Warns that nothing was placed where `removed` pieces were taken out. `given`: the pieces that stood from the start.
/// Empty for a run that may go on.
std::string empty_room_warning(std::size_t removed, std::size_t given, const master::CollageResult& result);

/// Says how many of the `removed` pieces came back to where they lay, because nothing else may come in for them. Empty for
/// a run that may go on. The first `given` pieces are no new ones. `silhouettes`: for each shape of the library, the first
/// shape that looks like it.
std::string come_back_warning(const std::vector<GivenPiece>& removed, std::size_t given, const Canvas& canvas,
                              const master::CollageResult& result, const std::vector<std::uint32_t>& silhouettes);

/// The texts that are not empty, with semicolons between them.
std::string joined_warnings(const std::vector<std::string>& warnings);

}  // namespace tessera
