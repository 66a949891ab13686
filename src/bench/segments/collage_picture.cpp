#include "bench/segments/collage_picture.h"

#include <algorithm>
#include <array>

#include "artwork/artwork_render.h"
#include "artwork/images/png_encoder.h"
#include "files/atomic_file.h"
#include "render/pieces/svg_path.h"
#include "text/xml_writer.h"

namespace tessera::bench {
namespace {

constexpr const char* kSeedColour = "#555555";
constexpr std::array<const char*, 6> kPieceColours = {"#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9"};
constexpr int kMostPictureSide_px = 1600;

}  // namespace

std::string collage_svg(const Canvas& canvas, const std::vector<Placement>& placements,
                        const std::vector<Shape>& shapes) {
  const std::string width = std::to_string(canvas.width_px);
  const std::string height = std::to_string(canvas.height_px);
  XmlWriter svg;
  svg.start("svg").attribute("xmlns", "http://www.w3.org/2000/svg");
  svg.attribute("width", width).attribute("height", height);
  svg.start("rect").attribute("width", width).attribute("height", height).attribute("fill", "#ffffff").end();
  for (std::size_t i = 0; i < placements.size(); ++i) {
    const Placement& placement = placements[i];
    svg.start("path").attribute("fill", i == 0 ? kSeedColour : kPieceColours[i % kPieceColours.size()]);
    svg.attribute("fill-rule", "evenodd");
    svg.attribute("d", svg_path(shapes[index_of(placement.shape)].outline.curves, placement.canvas_from_shape)).end();
  }
  return svg.finish();
}

void write_collage_picture(const Canvas& canvas, const std::vector<Placement>& placements,
                           const std::vector<Shape>& shapes, const std::string& path) {
  const std::string svg = collage_svg(canvas, placements, shapes);
  const std::vector<std::uint8_t> bytes(svg.begin(), svg.end());
  const int side_px = std::min(kMostPictureSide_px, 2 * std::max(canvas.width_px, canvas.height_px));
  write_file_atomically(path, png_of(render_artwork(bytes, path, side_px)));
}

}  // namespace tessera::bench
