// The picture that a result's pieces show together (colour.image), which the result keeps. It is drawn between the pieces
// (output.background = "image", so that gaps have the picture's colours), laid over them (colour.overlay), and is the aim
// of their tones (colour.shift).
#pragma once

#include <opencv2/core.hpp>
#include <string>

#include "core/field/canvas.h"
#include "job/job_file.h"
#include "layers/ground_tile.h"

namespace tessera {

/// The picture in the folder `dir`, over the whole canvas: straight BGRA, empty where there is none. Throws InputError
/// where it is damaged.
cv::Mat shown_picture(const std::string& dir);

/// The colour of the canvas below everything else: "#rrggbb" or kNoColour. White below a picture, which hides it.
std::string flat_background(const OutputSpec& output);

/// The picture in the folder `dir` as a tile that covers the canvas and does not repeat. Its colours are multiplied by
/// output.background_light, and its transparent parts are white. Throws InputError where the folder has no picture, or a
/// damaged one.
GroundTile image_background(const std::string& dir, const OutputSpec& output, const Canvas& canvas);

/// The picture that the collage shows, for CollageReport::overlay. Its pixels have this opacity; in the SVG the
/// layer has it. Empty where the opacity is 0. Throws like image_background(). Encoded sRGB is blended: a pixel that has
/// the picture's colour keeps it, so pieces are chosen by the same colours with and without an overlay.
GroundTile image_overlay(const std::string& dir, double opacity, const Canvas& canvas);

}  // namespace tessera
