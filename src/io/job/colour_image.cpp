#include "io/job/colour_image.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <opencv2/imgproc.hpp>
#include <span>
#include <utility>

#include "core/base/digest.h"
#include "core/base/error.h"
#include "io/artwork/artwork_render.h"
#include "io/drawing/drawers.h"
#include "io/job/canvas_file.h"
#include "io/job/canvas_page.h"

namespace tessera::io {
namespace {

constexpr float kTexelsPerPiece = 8;         // along the side of the smallest
constexpr std::size_t kShapesAtATime = 4096;  // heads alone: some MB
constexpr LibraryParts kHeadsOnly{.outline = false, .field = false, .levels = 0, .artwork = false};

cv::Size texels_of(const Canvas& canvas, float px_per_texel) {
  const auto along = [&](int px) { return std::max(1, int(std::ceil(float(px) / px_per_texel))); };
  return {along(canvas.width_px), along(canvas.height_px)};
}

/// The middle of the page, as large as it can be with the canvas' aspect.
cv::Mat covering_part(const cv::Mat& page, const Canvas& canvas) {
  const double fit = std::min(double(page.cols) / canvas.width_px, double(page.rows) / canvas.height_px);
  const cv::Size part(std::max(1, int(canvas.width_px * fit)), std::max(1, int(canvas.height_px * fit)));
  return page(cv::Rect({(page.cols - part.width) / 2, (page.rows - part.height) / 2}, part));
}

/// Means of straight BGRA, weighted by alpha.
Grid<Texel> texels_from(const cv::Mat& straight_bgra, cv::Size size) {
  cv::Mat bgr, lab, alpha, sums;
  cv::cvtColor(straight_bgra, bgr, cv::COLOR_BGRA2BGR);
  bgr.convertTo(bgr, CV_32F, 1.0 / 255);
  cv::cvtColor(bgr, lab, cv::COLOR_BGR2Lab);
  cv::extractChannel(straight_bgra, alpha, 3);
  alpha.convertTo(alpha, CV_32F, 1.0 / 255);
  cv::Mat weighted;
  const cv::Mat three[] = {alpha, alpha, alpha};
  cv::merge(three, 3, weighted);
  cv::multiply(lab, weighted, weighted);
  const cv::Mat four[] = {weighted, alpha};
  cv::merge(four, 2, sums);
  cv::resize(sums, sums, size, 0, 0, cv::INTER_AREA);
  Grid<Texel> texels(size.width, size.height);
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) {
      const cv::Vec4f& s = sums.at<cv::Vec4f>(y, x);
      texels(x, y) = {s[0], s[1], s[2], s[3]};
    }
  }
  return texels;
}

std::shared_ptr<const ColourTarget> target_of(const Canvas& canvas, const Job& job) {
  const float px_per_texel = std::max(1.f, job.settings.pieces.min_scale_px / kTexelsPerPiece);
  const cv::Size size = texels_of(canvas, px_per_texel);
  const auto bytes = read_canvas_file(job.colour.image, "colour.image");
  const int side_px = std::min(2 * std::max(size.width, size.height), kMaxArtworkSide_px);
  Drawers drawers(photo_drawer_settings(1));
  const cv::Mat page = drawers.picture(bytes, job.colour.image, side_px);
  const Grid<Texel> finest = texels_from(covering_part(page, canvas), size);
  if (std::none_of(finest.data().begin(), finest.data().end(),
                   [](const Texel& texel) { return texel.weight >= kLeastColourWeight; })) {
    throw InputError(job.path + ": colour.image: " + job.colour.image + " is transparent all over");
  }
  return std::make_shared<const ColourTarget>(finest, px_per_texel);
}

}  // namespace

void set_colours(std::shared_ptr<const ColourTarget> target, const ShapeLibrary& library, Job& job) {
  auto of_shapes = std::make_shared<std::vector<Lab>>();
  Digest digest;
  digest.add_all(std::span<const Texel>(target->texels()));
  for (std::size_t begin = 0; begin < library.size(); begin += kShapesAtATime) {
    for (const Shape& shape : library.read(begin, std::min(library.size(), begin + kShapesAtATime), kHeadsOnly)) {
      if (!shape.colour_grid.known()) {
        throw InputError(job.path + ": colour.image: " + library.path() + " does not know the colours of " + shape.name +
                         "'s parts, as libraries of older versions; build it again");
      }
      digest.add_all(std::span<const std::uint8_t>(shape.colour_grid.bytes));
      of_shapes->push_back({shape.mean_lab[0], shape.mean_lab[1], shape.mean_lab[2]});
    }
  }
  job.settings.colour.target = std::move(target);
  job.settings.colour.of_shapes = std::move(of_shapes);
  job.colour_digest = digest.value();
}

void set_colours(const Canvas& canvas, const ShapeLibrary& library, Job& job) {
  if (job.colour.image.empty()) return;
  if (job.canvas.seamless != Seamless::none) {
    throw InputError(job.path + ": colour.image: found with canvas.seamless, allowed: a canvas that does not repeat");
  }
  set_colours(target_of(canvas, job), library, job);
}

}  // namespace tessera::io
