#include "bench/blocking/known_silhouettes.h"

#include <opencv2/core.hpp>

#include "bench/blocking/seen_curves.h"
#include "core/base/rank_pool.h"
#include "core/shape/outline.h"
#include "core/shape/shape_builder.h"
#include "recognition/library_lots.h"

namespace tessera::bench {
namespace {

std::optional<KnownSilhouette> known_silhouette(const cv::Mat& mask, std::size_t silhouette, bool mirrored) {
  cv::Mat seen;
  if (mirrored) {
    cv::flip(mask, seen, 1);
  } else {
    seen = mask;
  }
  std::optional<Shape> shape = shape_of_mask(seen);
  if (!shape) return std::nullopt;
  ShapeModel model = make_shape_model(*shape, {}, {}, kSearchedLevels);
  return KnownSilhouette{silhouette, mirrored, std::move(shape->outline), shape->artwork.unit_px, std::move(model)};
}

}  // namespace

std::optional<Shape> shape_of_mask(const cv::Mat& mask) {
  for (const bool fill_holes : {false, true}) {
    const TracingRules rules{.keep_rectangles = true, .fill_holes = fill_holes};
    auto traced = trace_outline(coverage_of(mask), {0, 0}, 1, rules);
    if (const TracedOutline* outline = std::get_if<TracedOutline>(&traced)) return make_shape(*outline, {});
  }
  return std::nullopt;
}

SilhouetteLibrary make_silhouette_library(const std::vector<Silhouette>& silhouettes, bool mirrors) {
  const std::size_t ways = mirrors ? 2 : 1;
  std::vector<std::optional<KnownSilhouette>> made(silhouettes.size() * ways);
  parallel_for(made.size(),
               [&](std::size_t i) { made[i] = known_silhouette(silhouettes[i / ways].mask, i / ways, i % ways == 1); });
  SilhouetteLibrary library;
  for (std::size_t i = 0; i < made.size(); ++i) {
    if (made[i]) {
      library.shapes.push_back(std::move(*made[i]));
    } else if (i % ways == 0) {
      library.left_out.push_back(silhouettes[i / ways].name);
    }
  }
  return library;
}

}  // namespace tessera::bench
