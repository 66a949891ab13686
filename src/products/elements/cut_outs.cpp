#include "products/elements/cut_outs.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <variant>

#include "artwork/images/png_encoder.h"
#include "products/elements/element_surroundings.h"

namespace tessera {
namespace {

/// The number with as many digits as `count` has: 007 of 250.
std::string number_text(std::size_t number, std::size_t count) {
  const std::string text = std::to_string(number);
  return std::string(std::to_string(count).size() - text.size(), '0') + text;
}

}  // namespace

std::vector<CutOut> cut_outs(const std::string& photo, const cv::Mat& picture, const LabelRuns& labels,
                             const std::vector<LabelRole>& roles, const std::vector<PhotoElement>& elements) {
  const std::string first = photo + "/" + std::filesystem::path(photo).stem().string() + "_";
  const cv::Mat map = labels.labels();
  const int margin_px = surroundings_margin_px(elements);
  std::vector<CutOut> result;
  for (std::size_t i = 0; i < elements.size(); ++i) {
    const std::string path = first + number_text(i + 1, elements.size()) + ".png";
    result.push_back({path, photo, png_of(cut_element(picture, labels, elements[i])),
                      png_of(element_surroundings(picture, map, roles, elements[i], margin_px)), margin_px});
  }
  return result;
}

ShapeLoader cut_out_loader(Drawers& drawers, const std::vector<CutOut>& cut_outs, const TracingSettings& settings) {
  std::map<std::string, const CutOut*> cut_out_at;
  for (const CutOut& cut_out : cut_outs) cut_out_at[cut_out.path] = &cut_out;
  const auto load = [&drawers, cut_out_at, settings](const std::string& path) {
    const CutOut& cut_out = *cut_out_at.at(path);
    std::variant<ArtworkShape, SkipReason> loaded = drawers.shape(cut_out.png, path, settings);
    if (auto* artwork = std::get_if<ArtworkShape>(&loaded)) {
      artwork->shape.artwork.path = std::filesystem::absolute(cut_out.photo);
      artwork->shape.artwork.original = cut_out.png;
      artwork->shape.artwork.surroundings_png = cut_out.surroundings_png;
      artwork->shape.artwork.surroundings_margin_px = cut_out.surroundings_margin_px;
    }
    return loaded;
  };
  return {.load = load, .stop = [&drawers] { drawers.stop(); }};
}

}  // namespace tessera
