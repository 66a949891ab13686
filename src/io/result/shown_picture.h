// The picture that a result's pieces show together (colour.image): as the result keeps it, and as what lies between the
// pieces (output.background = "image"). Gaps in the picture's own colours do not grey it.
#pragma once

#include <cstdint>
#include <opencv2/core.hpp>
#include <string>
#include <vector>

#include "core/colour/colour_target.h"
#include "core/field/canvas.h"
#include "io/job/job_file.h"
#include "io/result/ground_tile.h"

namespace tessera::io {

/// In the folder of a result that shows a picture, so that `tessera draw` does not need the job's own file.
inline constexpr const char* kShownPictureName = "shown.png";

/// The picture over the whole canvas as a PNG with transparency, its longest side 1024 px or that of the canvas,
/// whichever is less.
std::vector<std::uint8_t> shown_picture_png(const ColourTarget& target, const Canvas& canvas);

/// The picture in the folder `dir`, straight BGRA; empty where there is none. Throws InputError where it is damaged.
cv::Mat shown_picture(const std::string& dir);

/// Of the canvas, beneath all else: "#rrggbb" or kNoColour. White below a picture, which hides it.
std::string flat_background(const OutputSpec& output);

/// The picture in the folder `dir`, its colours times output.background_light, as a tile that covers the canvas and does
/// not repeat. What is transparent in it is white. Throws InputError where the folder has none, or where it is damaged.
GroundTile image_background(const std::string& dir, const OutputSpec& output, const Canvas& canvas);

}  // namespace tessera::io
