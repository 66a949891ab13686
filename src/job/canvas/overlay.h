// A picture that a job lays over its canvas.
#pragma once

#include <opencv2/core.hpp>
#include <string>

#include "artwork/drawers/drawers.h"
#include "core/field/canvas.h"

namespace tessera {

/// The whole picture as straight BGRA, CV_8UC4; an SVG is drawn with a longest side of `side_px`. Throws InputError,
/// which begins with the key where the file cannot be read, and otherwise is that of Drawers::whole_picture. `drawers`
/// have the limits for photos (photo_drawer_settings); where they are stopped it throws DrawingStopped.
cv::Mat whole_overlay(const std::string& path, const char* key, int side_px, Drawers& drawers);

/// The largest part of the picture that has the canvas' aspect ratio and the same centre. Pixels and errors as in
/// whole_overlay.
cv::Mat overlay_picture(const std::string& path, const char* key, const Canvas& canvas, int side_px, Drawers& drawers);

}  // namespace tessera
