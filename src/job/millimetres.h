// Lengths in mm: a job whose canvas has a size on paper (canvas.size_mm) may give each length of its canvas so. The
// program knows px alone: what is in mm becomes px when the job is read.
#pragma once

#include <string>

#include "job/job_keys.h"

namespace tessera {

/// The longer side of a canvas whose job gives its size in mm alone.
inline constexpr int kPaperCanvasSide_px = 2000;

/// Of the canvas, by its longer side; 0 where it has no size on paper.
double px_per_mm(const CanvasSpec& canvas);

/// Makes a canvas with a size on paper as many px large as it is by default. Throws InputError where that is no canvas.
void set_default_px(CanvasSpec& canvas);

/// Throws InputError where a canvas with a size on paper has another aspect in px than in mm.
void check_aspect(const CanvasSpec& canvas);

/// Whether the key is a length of the canvas in px, which NAME_mm gives in mm for its NAME_px.
bool is_canvas_length(const JobKey& key);

/// "scale_px" for "scale_mm"; empty where the name does not end so.
std::string name_in_px(const std::string& name_in_mm);

/// The key as it is given in mm: its name and its range, to a thousandth.
JobKey key_in_mm(const JobKey& key_in_px, double px_per_mm);

/// What the key in mm has been read with, in px, within the range of the key in px.
JobValue value_in_px(const JobKey& key_in_px, JobValue value_in_mm, double px_per_mm);

}  // namespace tessera
