// The pictures that a job lays over its canvas: colour.image, whose colours the pieces are to show, and
// pieces.size_map, how large they may be from place to place.
#pragma once

#include <cstdint>
#include <memory>
#include <opencv2/core.hpp>
#include <string>
#include <vector>

#include "artwork/drawers/drawers.h"
#include "core/colour/colour_target.h"
#include "core/field/canvas.h"
#include "core/geometry/size_map.h"
#include "job/job_file.h"
#include "library/storage/shape_library.h"

namespace tessera {

/// colour.image over the canvas: the pixels, and the colours that pieces are matched with.
struct ColourImage {
  cv::Mat bgra;  // straight, CV_8UC4; its edges are the canvas' (overlay.h)
  std::shared_ptr<const ColourTarget> target;
};

/// Of the file `image` (colour.image); empty where that is "". `smallest_px`: the size of the smallest piece. Errors as
/// read_overlays but for the job's path, and as overlay_picture where `drawers` are stopped.
ColourImage read_colour_image(const Canvas& canvas, const std::string& image, float smallest_px, Drawers& drawers);

/// Longest side of the picture that a result keeps. Its PNG in Base64, as SVGs hold it, stays below the 10 MB that
/// libxml2 reads in one attribute, even where it is noise.
inline constexpr int kLongestShownSide_px = 1360;

/// colour.image as straight BGRA in a PNG; larger pictures are reduced to kLongestShownSide_px.
std::vector<std::uint8_t> shown_picture_png(const cv::Mat& bgra);

/// What is empty is not there.
struct Overlays {
  std::shared_ptr<const ColourTarget> colour;
  std::shared_ptr<const SizeMap> sizes;
  std::shared_ptr<const std::vector<std::uint8_t>> shown_png = {};
};

/// Read from the job's files, as finely as the smallest piece needs, whose size is `smallest_px`. Throws InputError that
/// names job, key and file: where that is no picture, where the colours are transparent all over, or the canvas is
/// seamless.
Overlays read_overlays(const Canvas& canvas, const Job& job, float smallest_px);

/// Makes them those of the job's settings. Throws InputError where the library does not know the colours of its
/// drawings' parts, as it is older, and they are asked for.
void set_overlays(const Overlays& overlays, const ShapeLibrary& library, Job& job);

}  // namespace tessera
