// What the library takes from an artwork file: its silhouette at a good resolution, its mean colour, a thumbnail.
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

/// The drawing (not the page) is brought to this longest side, as far as the source gives it.
inline constexpr int kSilhouetteSide_px = 512;
inline constexpr int kThumbnailSide_px = 192;

/// Weighted by alpha; CIELAB (D65).
struct ArtworkColour {
  std::array<float, 3> mean_lab{};  // 0 where nothing is drawn
  float spread = 0;                 // root mean square distance of the colours from the mean
};

/// Artwork frame: px of the whole page (width_px x height_px), y down.
struct Silhouette {
  std::string path;
  int width_px = 0;
  int height_px = 0;
  Grid<float> alpha;    // 0..1, of the part of the page that is drawn on
  Grid<float> body;     // the same, but for soft shadows and translucent parts (solid_coverage.h); empty: it is alpha
  int loose_parts = 0;  // see SolidCoverage (solid_coverage.h)
  bool loses_parts = false;     // the same
  bool loses_text = false;      // see ArtworkPage
  bool loses_pictures = false;  // the same
  Vec2 origin_px;               // upper left corner of alpha's upper left pixel
  float source_px = 0;          // size of a pixel of the source; 0 for vectors
  float drawn_px = 0;           // of the page's own px (1/96 inch of an SVG) for one of the raster
  ArtworkColour colour;
  StyleFeatures style;
  ColourRaster colours;                     // of the part of the page that is drawn on, coarse
  std::vector<std::uint8_t> thumbnail_png;  // the whole page, RGBA, longest side kThumbnailSide_px
};

/// Drawn on is what has `edge_opacity` at least. An opacity other than kEdgeOpacity was asked for, and is taken by the
/// word: there is no `body` then. Throws InputError as open_artwork_page (open_artwork_page.h) does. `path` is kept and stands
/// in messages.
Silhouette make_silhouette(std::span<const std::uint8_t> bytes, const std::string& path,
                           float edge_opacity = kEdgeOpacity);

}  // namespace tessera
