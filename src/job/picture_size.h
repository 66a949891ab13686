// How large the pictures of a collage are: in px, and on paper.
#pragma once

#include <opencv2/core.hpp>

#include "core/field/canvas.h"
#include "job/job_file.h"

namespace tessera {

inline constexpr double kMmPerInch = 25.4;

/// Of a canvas with a size on paper (canvas.size_mm) that is the size of the pictures, where the output gives none.
OutputSpec on_paper(OutputSpec output, const CanvasSpec& spec, const Canvas& canvas);

/// How large the pictures are on paper, mm; 0 x 0 where the output has no width_mm. Of a canvas with a size on paper it
/// has the aspect of that, of another one the aspect of the canvas.
cv::Size2d page_size_mm(const OutputSpec& output, const CanvasSpec& spec, const Canvas& canvas);

/// The page in px of the canvas: of a canvas with a size on paper, which is that to a px, it is that exactly, so that a
/// mm of the job is a mm of the page in x and in y. Of all others, and where copies are to meet, it is the canvas.
cv::Size2d page_size_px(const CanvasSpec& spec, const Canvas& canvas);

/// Of collage.png: width_mm at its dpi where it is given, else width_px.
int picture_width_px(const OutputSpec& output);
cv::Size picture_size_px(const OutputSpec& output, const Canvas& canvas);

/// Throws InputError, which names the key, where that size has less than 64 px in width or more than the widest picture
/// (output.width_px) in width or height.
void check_picture_size(const OutputSpec& output, const Canvas& canvas);

}  // namespace tessera
