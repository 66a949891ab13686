// The pictures that a job lays over its canvas: colour.image holds the colours that the pieces shall show,
// pieces.size_map the sizes that they may have at each place.
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
  cv::Mat bgra;  // straight, CV_8UC4; its edges are those of the canvas (overlay.h)
  std::shared_ptr<const ColourTarget> target;
};

/// Reads the file `image` (colour.image); empty where that is "". `smallest_px`: the size of the smallest piece. Errors
/// as read_overlays, without the job's path; as overlay_picture where `drawers` are stopped.
ColourImage read_colour_image(const Canvas& canvas, const std::string& image, float smallest_px, Drawers& drawers);

/// Longest side of the picture that a result keeps. As Base64 in an SVG its PNG stays below 10 MB, the most that
/// libxml2 reads in one attribute, even for noise.
inline constexpr int kLongestShownSide_px = 1360;

/// colour.image as straight BGRA in a PNG; larger pictures are reduced to kLongestShownSide_px.
std::vector<std::uint8_t> shown_picture_png(const cv::Mat& bgra);

/// The overlays of a job; one that the job does not have is null.
struct Overlays {
  std::shared_ptr<const ColourTarget> colour;
  std::shared_ptr<const SizeMap> sizes;
  std::shared_ptr<const std::vector<std::uint8_t>> shown_png = {};
};

/// Reads the overlays of the job's files, as finely as the smallest piece (`smallest_px`) needs. Throws InputError that
/// names job, key and file, where the file is no picture, its colours are transparent everywhere, or the canvas is
/// seamless.
Overlays read_overlays(const Canvas& canvas, const Job& job, float smallest_px);

/// Puts the overlays into the job's settings. Throws InputError where colours of drawings are needed and the library is
/// too old to hold them.
void set_overlays(const Overlays& overlays, const ShapeLibrary& library, Job& job);

}  // namespace tessera
