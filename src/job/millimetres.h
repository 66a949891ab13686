// Lengths in mm: a job whose canvas has a size on paper (canvas.size_mm) may give each length of its canvas in mm. The
// program computes in px only: lengths in mm become px when the job is read.
#pragma once

#include <string>

#include "job/job_keys.h"

namespace tessera {

/// The longer side of a canvas whose size is given only in mm.
inline constexpr int kPaperCanvasSide_px = 2000;

/// Canvas px for each mm, from its longer side; 0 where it has no size on paper.
double px_per_mm(const CanvasSpec& canvas);

/// Sets the default size in px of a canvas with a size on paper. Throws InputError where the result is no valid canvas.
void set_default_px(CanvasSpec& canvas);

/// Throws InputError where a canvas with a size on paper has different aspect ratios in px and in mm.
void check_aspect(const CanvasSpec& canvas);

/// Whether the key is a length of the canvas in px (NAME_px), so that NAME_mm may give it in mm.
bool is_canvas_length(const JobKey& key);

/// "scale_px" for "scale_mm"; empty where the name does not end in "_mm".
std::string name_in_px(const std::string& name_in_mm);

/// The key as given in mm: its name, and its range in thousandths of a mm.
JobKey key_in_mm(const JobKey& key_in_px, double px_per_mm);

/// A value read in mm, converted to px and limited to the range of the key in px.
JobValue value_in_px(const JobKey& key_in_px, JobValue value_in_mm, double px_per_mm);

}  // namespace tessera
