// Finds what keeps shapes out of a canvas, by trying on the empty canvas what a change of each key alone does; and says
// what helps.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/field/canvas.h"
#include "core/settings/settings.h"
#include "core/settings/wishes.h"
#include "core/shape/shape_id.h"
#include "job/job_file.h"
#include "library/storage/shape_library.h"
#include "run/messages/written_keys.h"

namespace tessera {

/// Shapes of which none, or too few, found a place in these regions of the canvas.
struct UnplacedShapes {
  std::vector<ShapeId> shapes;
  std::vector<std::uint32_t> regions;  // {0} where the canvas has no regions
};

/// The keys, with their values, of which a change of each alone lets one of the shapes lie on the empty canvas: sizes,
/// rotations, padding, zones. Empty where one of the shapes fits already, or no key alone helps. `sized`: the settings with
/// the sizes that were tried. `spec`: of the canvas.
std::vector<std::string> keys_that_keep_out(const WrittenKeys& keys, const CanvasSpec& spec,
                                            const CollageSettings& sized, const ShapeLibrary& library,
                                            const Canvas& canvas, const UnplacedShapes& unplaced);

/// Whether the job may have pieces.fit = "all".
bool may_fit_all(const WrittenKeys& keys);

/// Whether pieces have the sizes in which they were drawn (pieces.sizes).
bool has_drawn_sizes(const WrittenKeys& keys);

/// The places in the job that decide the sizes of these shapes: `scale_px of [[shapes]] "cat*" (now [5, 9]) or
/// pieces.scale_px (now [20, 160])`.
std::string where_sizes_stand(const WrittenKeys& keys, const Wishes& wishes, const UnplacedShapes& unplaced);

}  // namespace tessera
