#include "artwork/artwork_shape.h"

#include <filesystem>

#include "artwork/images/sha256.h"
#include "artwork/silhouette.h"
#include "core/base/error.h"
#include "core/geometry/extent.h"
#include "core/shape/shape_builder.h"

namespace tessera {
namespace {

/// The drawn size, or 0 where it is beyond these limits: a page may state any size.
float drawn_scale_px(float scale_px) { return scale_px >= 1e-3f && scale_px <= 1e6f ? scale_px : 0; }

/// The colours in cells over the outline's box.
ColourGrid colour_grid_of(const Silhouette& silhouette, const Shape& shape) {
  const Artwork& artwork = shape.artwork;
  const Extent box_px =
      extent_of(shape.outline.curves.front(), {artwork.unit_px, 0, artwork.centroid_px.x, artwork.centroid_px.y});
  return make_colour_grid(silhouette.colours, box_px.low, box_px.high);
}

using OutlineOrReason = std::variant<TracedOutline, SkipReason>;

bool is_outline(const OutlineOrReason& traced) { return std::holds_alternative<TracedOutline>(traced); }

struct Traced {
  OutlineOrReason outline;
  int loose_parts = 0;
  bool loses_parts = false;
};

/// Whether the body covers pixels that alpha alone does not.
bool body_is_larger(const Silhouette& silhouette, const TracingRules& rules) {
  constexpr int kLeastPixels = 256;
  int more = 0;
  for (int y = 0; y < silhouette.alpha.height(); ++y) {
    for (int x = 0; x < silhouette.alpha.width(); ++x) {
      more += silhouette.body(x, y) >= rules.edge_opacity && silhouette.alpha(x, y) < rules.edge_opacity;
    }
  }
  return more >= kLeastPixels;
}

/// The outline of the drawing's body. Where it gives no shape, e.g. for a translucent plate behind the drawing, that of
/// the opaque part.
Traced traced_outline(const Silhouette& silhouette, const TracingRules& rules) {
  const auto trace = [&](const Grid<float>& coverage) {
    return trace_outline(coverage, silhouette.origin_px, silhouette.source_px, rules);
  };
  if (silhouette.body.width() == 0) return {trace(silhouette.alpha), 0, silhouette.loses_parts};
  Traced by_body{trace(silhouette.body), silhouette.loose_parts, silhouette.loses_parts};
  if (is_outline(by_body.outline)) return by_body;
  Traced by_alpha{trace(silhouette.alpha), 0, silhouette.loses_parts || body_is_larger(silhouette, rules)};
  return is_outline(by_alpha.outline) ? by_alpha : by_body;
}

/// The reason to report. Where parts were lost because they are too faint, the rest does not explain why there is no
/// shape.
SkipReason true_reason(SkipReason reason, bool loses_parts) {
  const bool by_loss =
      reason == SkipReason::empty || reason == SkipReason::too_small || reason == SkipReason::several_large_components;
  return loses_parts && by_loss ? SkipReason::faint : reason;
}

/// Whether the drawing, which gives no shape, would give one with its holes filled.
bool is_hollow(const Silhouette& silhouette, TracingRules rules) {
  if (rules.fill_holes) return false;
  rules.fill_holes = true;
  const Traced filled = traced_outline(silhouette, rules);
  const auto* outline = std::get_if<TracedOutline>(&filled.outline);
  return outline && outline->hollowness >= kHollow;
}

}  // namespace

std::variant<ArtworkShape, SkipReason> shape_from_artwork(std::span<const std::uint8_t> bytes, const std::string& path,
                                                          const TracingSettings& settings) {
  Silhouette silhouette = make_silhouette(bytes, path, settings.rules);
  const Traced traced = traced_outline(silhouette, settings.rules);
  if (const auto* reason = std::get_if<SkipReason>(&traced.outline)) {
    if (silhouette.loses_text)
      throw InputError(path +
                       ": its text cannot be drawn: fontconfig finds no font on this "
                       "machine");
    return is_hollow(silhouette, settings.rules) ? SkipReason::hollow : true_reason(*reason, traced.loses_parts);
  }

  const auto& outline = std::get<TracedOutline>(traced.outline);
  Shape shape = make_shape(outline, settings.pad);
  shape.name = std::filesystem::path(path).stem();
  shape.mean_lab = silhouette.colour.mean_lab;
  shape.colour_spread = silhouette.colour.spread;
  shape.colour_grid = colour_grid_of(silhouette, shape);
  shape.drawn_scale_px = drawn_scale_px(silhouette.drawn_px * shape.artwork.unit_px);
  shape.artwork.path = std::filesystem::absolute(path);
  shape.artwork.sha256 = sha256_of(bytes);
  shape.artwork.width_px = silhouette.width_px;
  shape.artwork.height_px = silhouette.height_px;
  shape.artwork.thumbnail_png = std::move(silhouette.thumbnail_png);
  return ArtworkShape{.shape = std::move(shape),
                      .other_components = outline.other_components + traced.loose_parts,
                      .other_area_fraction = outline.other_area_fraction,
                      .loses_parts = traced.loses_parts,
                      .loses_text = silhouette.loses_text,
                      .loses_pictures = silhouette.loses_pictures,
                      .hollowness = outline.hollowness,
                      .style = silhouette.style};
}

}  // namespace tessera
