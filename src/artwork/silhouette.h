// The data that a library stores of an artwork file: its silhouette at a good resolution, its mean colour, a thumbnail.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/colour/colour_grid.h"
#include "core/geometry/grid.h"
#include "core/geometry/vec2.h"
#include "core/shape/outline.h"
#include "core/style/style_features.h"

namespace tessera {

/// Longest side of the drawing (not the page) as it is traced, if the source has that many pixels.
inline constexpr int kSilhouetteSide_px = 512;
inline constexpr int kThumbnailSide_px = 192;

/// Colours in CIELAB (D65), weighted by alpha.
struct ArtworkColour {
  std::array<float, 3> mean_lab{};  // 0 where nothing is drawn
  float spread = 0;                 // root mean square distance of the colours from the mean
};

/// The silhouette in the artwork frame: px of the whole page (width_px x height_px), y down.
struct Silhouette {
  std::string path;
  int width_px = 0;
  int height_px = 0;
  Grid<float> alpha;    // 0..1, of the part of the page with the drawing
  Grid<float> body;     // the same without shadows, with translucent parts (solid_coverage.h); empty: equal to alpha
  int loose_parts = 0;  // see SolidCoverage (solid_coverage.h)
  bool loses_parts = false;     // the same
  bool loses_text = false;      // see ArtworkPage
  bool loses_pictures = false;  // the same
  Vec2 origin_px;               // upper left corner of alpha's upper left pixel
  float source_px = 0;          // size of a pixel of the source; 0 for vectors
  float drawn_px = 0;           // px of the page (1/96 inch of an SVG) for one px of the raster
  ArtworkColour colour;
  StyleFeatures style;
  ColourRaster colours;                     // of the part of the page with the drawing, coarse
  std::vector<std::uint8_t> thumbnail_png;  // the whole page, RGBA, longest side kThumbnailSide_px
};

/// Makes the silhouette. A pixel belongs to the drawing if its alpha is at least `rules.edge_opacity`. A value other than
/// kEdgeOpacity is a request of the user, and is applied literally: there is no `body` then, nor with `rules.opaque`.
/// Throws InputError as open_artwork_page (open_artwork_page.h) does. `path` is kept and used in messages.
Silhouette make_silhouette(std::span<const std::uint8_t> bytes, const std::string& path,
                           const TracingRules& rules = {});

}  // namespace tessera
