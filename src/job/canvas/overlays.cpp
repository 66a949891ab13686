#include "job/canvas/overlays.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <span>
#include <utility>
#include <vector>

#include "artwork/images/colour_conversion.h"
#include "artwork/images/png_encoder.h"
#include "artwork/images/png_picture.h"
#include "core/base/digest.h"
#include "core/base/error.h"
#include "job/canvas/overlay.h"

namespace tessera {
namespace {

constexpr float kTexelsPerPiece = 8;  // along the side of the smallest piece
constexpr float kSizesPerPiece = 2;
/// Steps to which values are rounded: OpenCV's sums differ between machines, but far below one step.
constexpr float kStepsOfColour = 256;
constexpr float kStepsOfSize = 1024;
constexpr int kStripRows = 64;
constexpr std::size_t kShapesAtATime = 4096;  // without outlines and artwork: some MB
constexpr LibraryParts kHeadsOnly{.outline = false, .field = false, .levels = 0, .artwork = false};

float in_steps(float value, float steps) { return std::nearbyint(value * steps) / steps; }

/// Cell size of a grid over the canvas with this many cells along the side of the smallest piece.
float px_per_cell(float smallest_px, float cells_per_piece) { return std::max(1.f, smallest_px / cells_per_piece); }

cv::Size cells_of(const Canvas& canvas, float px_per_cell) {
  const auto along = [&](int px) { return std::max(1, int(std::ceil(float(px) / px_per_cell))); };
  return {along(canvas.width_px), along(canvas.height_px)};
}

/// Size at which an SVG is drawn: twice as fine as the cells.
int side_for(cv::Size cells) { return 2 * std::max(cells.width, cells.height); }

void refuse_seamless(const Canvas& canvas, const char* key) {
  if (!canvas.period.repeats()) return;
  throw InputError(std::string(key) + ": found with canvas.seamless, allowed: a canvas that does not repeat");
}

/// Lightness, a and b, each times alpha, and alpha itself, from straight BGRA. It works in strips, as each pixel needs
/// as much memory again in between.
cv::Mat weighted_lab(const cv::Mat& straight_bgra) {
  cv::Mat sums(straight_bgra.size(), CV_32FC4);
  for (int top = 0; top < sums.rows; top += kStripRows) {
    const cv::Range rows(top, std::min(sums.rows, top + kStripRows));
    const cv::Mat strip = straight_bgra.rowRange(rows), lab = lab_image_of(strip);
    for (int y = 0; y < strip.rows; ++y) {
      for (int x = 0; x < strip.cols; ++x) {
        const float alpha = float(strip.at<cv::Vec4b>(y, x)[3]) * (1.f / 255);
        const cv::Vec3f& c = lab.at<cv::Vec3f>(y, x);
        sums.at<cv::Vec4f>(top + y, x) = {c[0] * alpha, c[1] * alpha, c[2] * alpha, alpha};
      }
    }
  }
  return sums;
}

/// Means over texels, weighted by alpha.
Grid<Texel> texels_from(const cv::Mat& straight_bgra, cv::Size size) {
  cv::Mat sums = weighted_lab(straight_bgra);
  cv::resize(sums, sums, size, 0, 0, cv::INTER_AREA);
  Grid<Texel> texels(size.width, size.height);
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) {
      const cv::Vec4f& s = sums.at<cv::Vec4f>(y, x);
      texels(x, y) = {in_steps(s[0], kStepsOfColour), in_steps(s[1], kStepsOfColour), in_steps(s[2], kStepsOfColour),
                      in_steps(s[3], kStepsOfColour)};
    }
  }
  return texels;
}

/// The size map from the stored lightness; transparent places count as white.
std::shared_ptr<const SizeMap> size_map_of(const Canvas& canvas, const std::string& file, float smallest_px,
                                           Drawers& drawers) {
  if (file.empty()) return nullptr;
  refuse_seamless(canvas, "pieces.size_map");
  const float cell_px = px_per_cell(smallest_px, kSizesPerPiece);
  const cv::Size size = cells_of(canvas, cell_px);
  const cv::Mat bgra = overlay_picture(file, "pieces.size_map", canvas, side_for(size), drawers);
  cv::Mat grey, alpha, cells;
  cv::cvtColor(bgra, grey, cv::COLOR_BGRA2GRAY);
  cv::extractChannel(bgra, alpha, 3);
  cv::Mat(grey.size(), CV_8U, cv::Scalar(255)).copyTo(grey, alpha < 128);
  grey.convertTo(grey, CV_32F, 1.0 / 255);
  cv::resize(grey, cells, size, 0, 0, cv::INTER_AREA);
  SizeMap map{Grid<float>(size.width, size.height), 1 / cell_px};
  for (int y = 0; y < size.height; ++y) {
    std::transform(cells.ptr<float>(y), cells.ptr<float>(y) + size.width, map.part.row(y),
                   [](float part) { return in_steps(part, kStepsOfSize); });
  }
  return std::make_shared<const SizeMap>(std::move(map));
}

template <class Take>
void for_each_shape(const ShapeLibrary& library, Take take) {
  for (std::size_t begin = 0; begin < library.size(); begin += kShapesAtATime) {
    for (const Shape& shape : library.read(begin, std::min(library.size(), begin + kShapesAtATime), kHeadsOnly))
      take(shape);
  }
}

std::shared_ptr<const std::vector<ShapeColour>> colours_of(const ShapeLibrary& library) {
  auto colours = std::make_shared<std::vector<ShapeColour>>();
  for_each_shape(library, [&](const Shape& shape) {
    colours->push_back({{shape.mean_lab[0], shape.mean_lab[1], shape.mean_lab[2]}, own_contrast(shape.colour_grid)});
  });
  return colours;
}

/// Throws InputError where the library does not know the colours of its drawings' parts.
void add_colour_grids(const ShapeLibrary& library, const Job& job, Digest& digest) {
  for_each_shape(library, [&](const Shape& shape) {
    if (!shape.colour_grid.known()) {
      throw InputError(job.path + ": colour.image: " + library.path() + " does not know the colours of " + shape.name +
                       "'s parts, as libraries of older versions; build it again");
    }
    digest.add_all(std::span<const std::uint8_t>(shape.colour_grid.bytes));
  });
}

/// `bgra` is colour.image as matching uses it. Where it is small the file may be an SVG, which is drawn again, larger.
std::shared_ptr<const std::vector<std::uint8_t>> shown_png(const Canvas& canvas, const std::string& image,
                                                           const cv::Mat& bgra, Drawers& drawers) {
  const bool small = std::max(bgra.cols, bgra.rows) < kLongestShownSide_px;
  const cv::Mat picture = small ? overlay_picture(image, "colour.image", canvas, kLongestShownSide_px, drawers) : bgra;
  return std::make_shared<const std::vector<std::uint8_t>>(shown_picture_png(picture));
}

}  // namespace

ColourImage read_colour_image(const Canvas& canvas, const std::string& image, float smallest_px, Drawers& drawers) {
  if (image.empty()) return {};
  refuse_seamless(canvas, "colour.image");
  const float px_per_texel = px_per_cell(smallest_px, kTexelsPerPiece);
  const cv::Size size = cells_of(canvas, px_per_texel);
  const cv::Mat picture = overlay_picture(image, "colour.image", canvas, side_for(size), drawers);
  const Grid<Texel> finest = texels_from(picture, size);
  if (std::none_of(finest.data().begin(), finest.data().end(),
                   [](const Texel& texel) { return texel.weight >= kLeastColourWeight; })) {
    throw InputError("colour.image: " + image + " is transparent all over");
  }
  return {picture, std::make_shared<const ColourTarget>(finest, px_per_texel)};
}

std::vector<std::uint8_t> shown_picture_png(const cv::Mat& bgra) { return png_of(shrunk(bgra, kLongestShownSide_px)); }

Overlays read_overlays(const Canvas& canvas, const Job& job, float smallest_px) {
  try {
    Drawers drawers(photo_drawer_settings(1));
    Overlays overlays;
    const ColourImage image = read_colour_image(canvas, job.colour.image, smallest_px, drawers);
    overlays.colour = image.target;
    if (image.target) overlays.shown_png = shown_png(canvas, job.colour.image, image.bgra, drawers);
    overlays.sizes = size_map_of(canvas, job.size_map, smallest_px, drawers);
    return overlays;
  } catch (const InputError& error) {
    throw InputError(job.path + ": " + error.what());
  }
}

void set_overlays(const Overlays& overlays, const ShapeLibrary& library, Job& job) {
  Digest digest;
  if (overlays.colour) {
    digest.add_all(std::span<const Texel>(overlays.colour->texels()));
    add_colour_grids(library, job, digest);
  }
  if (overlays.colour || job.settings.colour.neighbours != 0) job.settings.colour.of_shapes = colours_of(library);
  if (overlays.sizes) digest.add_all(std::span<const float>(overlays.sizes->part.data()));
  job.settings.colour.target = overlays.colour;
  job.settings.pieces.size_map = overlays.sizes;
  job.shown_png = overlays.shown_png;
  job.overlay_digest = digest.value();
}

}  // namespace tessera
