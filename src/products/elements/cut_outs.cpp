#include "products/elements/cut_outs.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <utility>
#include <variant>

#include "artwork/images/png_encoder.h"
#include "core/base/rank_pool.h"
#include "library/storage/library_layout.h"
#include "products/elements/element_surroundings.h"

namespace tessera {
namespace {

/// The number with as many digits as `count` has: 007 of 250.
std::string number_text(std::size_t number, std::size_t count) {
  const std::string text = std::to_string(number);
  return std::string(std::to_string(count).size() - text.size(), '0') + text;
}

struct LabelledPhoto {
  const cv::Mat& picture;
  const cv::Mat& labels;
  const std::vector<LabelRole>& roles;
};

/// Adds surroundings with that margin, or a smaller one where a library could not hold them; none of a huge element.
void add_surroundings(const LabelledPhoto& photo, const PhotoElement& element, int margin_px, CutOut& cut_out) {
  for (int margin = margin_px; margin > 0; margin /= 2) {
    std::vector<std::uint8_t> png =
        png_of(element_surroundings(photo.picture, photo.labels, photo.roles, element, margin));
    if (png.size() > layout::kMaxSurroundingsBytes) continue;
    cut_out.surroundings_png = std::move(png);
    cut_out.surroundings_margin_px = margin;
    return;
  }
}

}  // namespace

std::vector<CutOut> cut_outs(const std::string& photo, const cv::Mat& picture, const LabelRuns& labels,
                             const std::vector<LabelRole>& roles, const std::vector<PhotoElement>& elements) {
  const std::string first = photo + "/" + std::filesystem::path(photo).stem().string() + "_";
  const cv::Mat map = labels.labels();
  const int margin_px = surroundings_margin_px(elements);
  std::vector<CutOut> result(elements.size());
  parallel_for(elements.size(), [&](std::size_t i) {
    CutOut& cut_out = result[i];
    cut_out.path = first + number_text(i + 1, elements.size()) + ".png";
    cut_out.photo = photo;
    cut_out.png = png_of(cut_element(picture, labels, elements[i]));
    add_surroundings({picture, map, roles}, elements[i], margin_px, cut_out);
  });
  return result;
}

ShapeLoader cut_out_loader(Drawers& drawers, const std::vector<CutOut>& cut_outs, const TracingSettings& settings) {
  std::map<std::string, const CutOut*> cut_out_at;
  for (const CutOut& cut_out : cut_outs) cut_out_at[cut_out.path] = &cut_out;
  TracingSettings of_cut_outs = settings;
  of_cut_outs.rules.opaque = true;
  const auto load = [&drawers, cut_out_at, of_cut_outs](const std::string& path) {
    const CutOut& cut_out = *cut_out_at.at(path);
    std::variant<ArtworkShape, SkipReason> loaded = drawers.shape(cut_out.png, path, of_cut_outs);
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
