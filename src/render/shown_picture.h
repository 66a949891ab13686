// The picture that a result's pieces show together (colour.image), which the result keeps: as what lies between the
// pieces (output.background = "image"; gaps in the picture's own colours do not grey it), as what is laid over them
// (colour.overlay), and as what their tones go towards (colour.shift).
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

/// Of the canvas, beneath all else: "#rrggbb" or kNoColour. White below a picture, which hides it.
std::string flat_background(const OutputSpec& output);

/// The picture in the folder `dir`, its colours times output.background_light, as a tile that covers the canvas and does
/// not repeat; what is transparent in it is white. Throws InputError where the folder has none, or where it is damaged.
GroundTile image_background(const std::string& dir, const OutputSpec& output, const Canvas& canvas);

/// The same picture for CollageReport::overlay. Its pixels have this opacity; in the SVG the layer has it. Empty where
/// the opacity is 0. Errors as of image_background. sRGB is blended as it is coded: a pixel that has the picture's colour
/// keeps it, so pieces are chosen by the same colours with an overlay and without.
GroundTile image_overlay(const std::string& dir, double opacity, const Canvas& canvas);

}  // namespace tessera
