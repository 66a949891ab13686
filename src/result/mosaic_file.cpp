#include "result/mosaic_file.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "artwork/artwork_render.h"
#include "artwork/drawers/drawers.h"
#include "artwork/images/image_decoding.h"
#include "artwork/images/image_header.h"
#include "core/base/count_text.h"
#include "core/base/error.h"
#include "files/regular_file.h"
#include "job/canvas/overlay.h"
#include "result/picture_cells.h"

namespace tessera {
namespace {

constexpr double kMostStretch = 1.05;
constexpr std::size_t kMostFileBytes = std::size_t(4 * kMaxImagePixels);  // as many bytes as the pixels have

cv::Mat read_mosaic(const std::string& path, Drawers& drawers) {
  const std::vector<std::uint8_t> bytes = read_regular_file(path, kMostFileBytes);
  return drawers.whole_picture(bytes, path, kMaxArtworkSide_px);
}

/// Refuses another aspect. `shown`: names what has the right aspect, for the message.
void check_aspect(const std::string& path, const cv::Mat& mosaic, cv::Size size, const std::string& shown) {
  const double stretch = double(mosaic.cols) * size.height / (double(mosaic.rows) * size.width);
  if (stretch <= kMostStretch && stretch >= 1 / kMostStretch) return;
  throw InputError(path + ": found " + size_text(mosaic.cols, mosaic.rows) + " px, allowed: the aspect of " + shown +
                   ", " + size_text(size.width, size.height) + ", to 5 %; cut one of them to what both show");
}

SeenFromAfar compared(const cv::Mat& mosaic, const cv::Mat& picture, const ShownImage& image, const Canvas* canvas,
                      double pieces_in_width) {
  MosaicCells cells(mosaic.size());
  cells.write(mosaic);
  const PicturePair pair =
      picture_pair(cells.cells(), cells_of_picture(picture, comparison_cells(mosaic.size())), canvas);
  const std::optional<SeenFromAfar> seen = seen_from_afar(pair, pieces_in_width);
  if (seen) return *seen;
  throw InputError(std::string(image.key) + ": " + image.path + " is transparent all over" +
                   (canvas ? " the canvas" : ""));
}

int longest_side(const cv::Mat& mosaic) {
  const cv::Size cells = comparison_cells(mosaic.size());
  return std::max(cells.width, cells.height);
}

}  // namespace

SeenFromAfar mosaic_from_afar(const std::string& path, const ShownImage& image, std::size_t pieces) {
  Drawers drawers(photo_drawer_settings(1));
  const cv::Mat mosaic = read_mosaic(path, drawers);
  if (mosaic.cols < kAfarWidth_px) {
    throw InputError(path + ": found " + size_text(mosaic.cols, mosaic.rows) +
                     " px, allowed: " + std::to_string(kAfarWidth_px) + " px wide or more");
  }
  const cv::Mat picture = whole_overlay(image.path, image.key, longest_side(mosaic), drawers);
  check_aspect(path, mosaic, picture.size(), image.path);
  const double in_width = std::sqrt(double(pieces) * mosaic.cols / mosaic.rows);
  return compared(mosaic, picture, image, nullptr, in_width);
}

SeenFromAfar mosaic_from_afar(const std::string& path, const ShownImage& image, const Canvas& canvas,
                              std::size_t pieces) {
  Drawers drawers(photo_drawer_settings(1));
  const cv::Mat mosaic = read_mosaic(path, drawers);
  check_aspect(path, mosaic, {canvas.width_px, canvas.height_px}, "the canvas");
  const cv::Mat picture = overlay_picture(image.path, image.key, canvas, longest_side(mosaic), drawers);
  return compared(mosaic, picture, image, &canvas, width_in_pieces(canvas, pieces));
}

bool looks_like_picture(const std::string& path) {
  std::array<std::uint8_t, 4096> begin;
  try {
    const std::size_t read = read_at(path, open_regular_file(path), 0, begin);
    return image_size_from_header(std::span(begin).first(read)).has_value();
  } catch (const InputError&) {
    return false;
  }
}

}  // namespace tessera
