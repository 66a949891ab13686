#include "report/picture_block.h"

#include <algorithm>

#include "artwork/artwork_render.h"
#include "artwork/drawers/drawers.h"
#include "artwork/images/image_header.h"
#include "core/base/error.h"
#include "files/regular_file.h"
#include "job/canvas/overlays.h"
#include "report/picture_tiles.h"
#include "result/folder/result_file.h"

namespace tessera {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kMostFileBytes = std::size_t(1) << 30;
/// Enough for a decoded picture of 20,000 x 20,000 px and its file.
constexpr DrawerSettings kDrawers{.seconds_per_drawing = 120, .bytes_per_process = std::size_t(3) << 30};

struct Picture {
  cv::Mat bgra;  // at most kMaxArtworkSide_px each way; empty: there is none
  cv::Size2d full_px;
};

/// A missing or damaged picture is no error: tessera draw makes it, and the page shows the pieces without it.
Picture read_picture(const std::string& folder, std::vector<std::string>& warnings) {
  const std::string path = path_in_result(folder, "collage.png");
  if (!is_in_result(folder, "collage.png")) {
    warnings.push_back("the page has no picture: " + path + ": no such file; tessera draw " + folder + " makes it");
    return {};
  }
  try {
    const std::vector<std::uint8_t> bytes = read_regular_file(path, kMostFileBytes);
    const std::optional<cv::Size2d> full = image_size_from_header(bytes);
    if (!full) throw InputError(path + ": not a PNG");
    Drawers drawers(kDrawers);
    return {drawers.decode_png(bytes, path, kMaxArtworkSide_px), *full};
  } catch (const InputError& error) {
    warnings.push_back(std::string("the page has no picture: ") + error.what() + "; tessera draw " + folder +
                       " makes it again");
    return {};
  }
}

/// The colour between the pieces, "#rrggbb"; null where that is transparent, a picture, or of several colours.
Json background_of(const WholeResult& result) {
  const auto& pictures = result.manifest.pictures;
  const auto png = std::find_if(pictures.begin(), pictures.end(),
                                [](const DrawnPicture& picture) { return picture.file == "collage.png"; });
  const bool drawn = png != pictures.end();
  const OutputSpec& output = drawn ? png->output : result.job.output;
  const double overlay = drawn ? png->overlay : result.job.colour.overlay;
  const std::vector<std::string>& regions = result.job.canvas.region_backgrounds;
  const bool one_colour = output.background.starts_with('#') && output.ground.empty() && overlay == 0 &&
                          std::all_of(regions.begin(), regions.end(), [](const std::string& c) { return c.empty(); });
  return one_colour ? Json(output.background) : Json();
}

}  // namespace

nlohmann::ordered_json picture_data(const std::string& folder, const WholeResult& result, std::size_t number,
                                    std::size_t most_bytes, Page& page) {
  const Picture picture = read_picture(folder, page.warnings);
  if (picture.bgra.empty()) return nullptr;
  PicturePyramid pyramid = picture_pyramid(picture.bgra, most_bytes);
  Json levels = Json::array();
  for (std::size_t level = 0; level < pyramid.size(); ++level) {
    PictureLevel& l = pyramid[level];
    levels.push_back({{"width_px", l.size_px.width}, {"height_px", l.size_px.height}});
    for (std::size_t tile = 0; tile < l.tiles.size(); ++tile) {
      const std::size_t column = tile % std::size_t(l.columns), row = tile / std::size_t(l.columns);
      page.blocks.push_back({"tile-" + std::to_string(number) + "-" + std::to_string(level) + "-" +
                                 std::to_string(column) + "-" + std::to_string(row),
                             std::move(l.tiles[tile])});
    }
  }
  return {{"picture", number},
          {"full_width_px", int(picture.full_px.width)},
          {"full_height_px", int(picture.full_px.height)},
          {"tile_px", kPictureTile_px},
          {"levels", levels},
          {"background", background_of(result)}};
}

}  // namespace tessera
