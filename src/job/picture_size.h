// The size of the pictures of a collage, in px and on paper.
#pragma once

#include <opencv2/core.hpp>

#include "core/field/canvas.h"
#include "job/job_file.h"

namespace tessera {

inline constexpr double kMmPerInch = 25.4;

/// The output with a size on paper: where it gives none, it gets that of the canvas (canvas.size_mm), if there is one.
OutputSpec on_paper(OutputSpec output, const CanvasSpec& spec, const Canvas& canvas);

/// The size of the pictures on paper in mm; 0 x 0 where the output has no width_mm. Its aspect ratio is that of
/// canvas.size_mm where that is given, otherwise that of the canvas in px.
cv::Size2d page_size_mm(const OutputSpec& output, const CanvasSpec& spec, const Canvas& canvas);

/// The size of the page in canvas px. With canvas.size_mm it is exactly that size, which differs from the canvas by
/// less than a px, so that a mm of the job is a mm of the page in x and y. Otherwise, and on a seamless canvas, it is
/// the canvas' size.
cv::Size2d page_size_px(const CanvasSpec& spec, const Canvas& canvas);

/// Width of collage.png: width_mm at its dpi where that is given, else width_px.
int picture_width_px(const OutputSpec& output);
cv::Size picture_size_px(const OutputSpec& output, const Canvas& canvas);

/// Throws InputError, which names the key, where the picture is narrower than 64 px, or wider or higher than the
/// largest allowed output.width_px.
void check_picture_size(const OutputSpec& output, const Canvas& canvas);

}  // namespace tessera
