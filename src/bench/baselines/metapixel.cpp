#include "bench/baselines/metapixel.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <opencv2/imgproc.hpp>
#include <span>

#include "artwork/artwork_render.h"
#include "artwork/drawers/drawers.h"
#include "artwork/images/colour_conversion.h"
#include "artwork/images/image_decoding.h"
#include "artwork/images/png_encoder.h"
#include "bench/baselines/program_run.h"
#include "core/base/error.h"
#include "core/base/rank_pool.h"
#include "files/atomic_file.h"

namespace tessera::bench {
namespace {

namespace fs = std::filesystem;

constexpr int kTile_px = 64;
constexpr int kDistance_tiles = 2;
constexpr std::size_t kShapesAtATime = 256;
constexpr int kThumbnailSide_px = 1024;  // as large as in any version of a library

std::string drawings_in(const Tiles& tiles) { return tiles.folder + "/drawings"; }
std::string prepared_in(const Tiles& tiles) { return tiles.folder + "/prepared"; }

/// The straight BGRA picture on one colour.
cv::Mat on_ground(const cv::Mat& bgra, const cv::Vec3b& ground) {
  cv::Mat bgr(bgra.size(), CV_8UC3);
  for (int y = 0; y < bgra.rows; ++y) {
    for (int x = 0; x < bgra.cols; ++x) {
      const cv::Vec4b& p = bgra.at<cv::Vec4b>(y, x);
      for (int c = 0; c < 3; ++c)
        bgr.at<cv::Vec3b>(y, x)[c] = std::uint8_t((p[c] * p[3] + ground[c] * (255 - p[3]) + 127) / 255);
    }
  }
  return bgr;
}

void write_png(const std::string& path, const cv::Mat& bgr) { write_file_atomically(path, png_of(bgr)); }

/// The largest distance at which enough drawings are left for each tile.
int distance_with(std::size_t drawings) {
  int distance = kDistance_tiles;
  while (distance > 0 && std::size_t((2 * distance + 1) * (2 * distance + 1)) > drawings) --distance;
  return distance;
}

}  // namespace

bool has_metapixel() { return is_in_path("metapixel") && is_in_path("metapixel-prepare"); }

Tiles write_tiles(const LibraryFile& library, const std::string& ground, const std::string& folder) {
  Tiles tiles{folder, 0};
  fs::create_directories(drawings_in(tiles));
  fs::create_directories(prepared_in(tiles));
  Drawers drawers({});
  const LibraryParts kThumbnails{.outline = false, .field = false, .levels = 0, .artwork = true};
  for (std::size_t begin = 0; begin < library.size(); begin += kShapesAtATime) {
    const std::size_t end = std::min(library.size(), begin + kShapesAtATime);
    for (const Shape& shape : library.read(begin, end, kThumbnails)) {
      if (shape.artwork.thumbnail_png.empty()) continue;
      const cv::Mat drawing = drawers.decode_png(shape.artwork.thumbnail_png, shape.name, kThumbnailSide_px);
      const std::string name = std::to_string(tiles.count++) + ".png";
      write_png(drawings_in(tiles) + "/" + name, on_ground(drawing, bgr_of(ground)));
    }
  }
  if (tiles.count == 0) throw InputError(library.path() + ": has no drawings, only outlines; metapixel needs drawings");
  return tiles;
}

TileGrid tile_grid(cv::Size image_px, std::size_t pieces) {
  TileGrid grid;
  const double aspect = double(image_px.width) / image_px.height, count = double(std::max<std::size_t>(1, pieces));
  grid.columns = std::max(1, int(std::lround(std::sqrt(count * aspect))));
  grid.rows = std::max(1, int(std::lround(grid.columns / aspect)));
  const double by_side = double(kMaxArtworkSide_px) / std::max(grid.columns, grid.rows);
  const double by_area = std::sqrt(kMaxImagePixels / (double(grid.columns) * grid.rows));
  grid.tile_px = std::clamp(int(std::min(by_side, by_area)), 1, kTile_px);
  return grid;
}

std::string write_tiled_image(const cv::Mat& image_bgr, const TileGrid& grid, const Tiles& tiles) {
  cv::Mat scaled;
  cv::resize(image_bgr, scaled, {grid.columns * grid.tile_px, grid.rows * grid.tile_px}, 0, 0, cv::INTER_AREA);
  const std::string path = tiles.folder + "/image.png";
  write_png(path, scaled);
  return path;
}

void make_metapixel_mosaic(const Tiles& tiles, const std::string& image, const TileGrid& grid,
                           const std::string& mosaic) {
  const std::string side = std::to_string(grid.tile_px);
  const std::string width = "--width=" + side, height = "--height=" + side;
  run_program({"metapixel-prepare", drawings_in(tiles), prepared_in(tiles), width, height}, ProgramOutput::no);
  run_program({"metapixel", "--metapixel", image, mosaic, "--library=" + prepared_in(tiles), width, height, "--scale=1",
               "--distance=" + std::to_string(distance_with(tiles.count)), "--metric=subpixel"},
              ProgramOutput::no);
}

}  // namespace tessera::bench
