#include "library/storage/library_check.h"

#include <algorithm>
#include <iterator>
#include <string>

#include "core/base/error.h"
#include "library/storage/library_layout.h"
#include "library/storage/thumbnail_png.h"

namespace tessera {
namespace {

using namespace layout;

/// Checks one shape; all checks report in the same form.
class ShapeCheck {
 public:
  ShapeCheck(const Shape& shape, const StyleFeatures& style) : shape_(shape), style_(style) {}

  void all() const {
    check_texts();
    check_outline();
    check_field();
    for (std::size_t k = 0; k < kSmoothingLevels.size(); ++k) check_level(shape_.levels[k], kSmoothingLevels[k]);
    check_artwork();
  }

 private:
  void require(bool holds, const std::string& what) const {
    if (holds) return;
    throw InputError("shape " + shape_.name + " (" + shape_.artwork.path + ") does not fit a library: " + what);
  }

  void require_length(float value, const std::string& what) const {
    require(all_within(&value, 1, kLeastLength, kMaxCoordinate), what);
  }

  void check_texts() const {
    require(!shape_.name.empty() && shape_.name.size() < kNameBytes, "its name is empty or too long");
    require(shape_.artwork.path.size() < kPathBytes, "its path is too long");
    require(all_within(shape_.mean_lab.data(), 3, -kMaxLab, kMaxLab), "its colour is out of range");
    require(all_within(&shape_.colour_spread, 1, -1, kMaxLab), "its colours are out of range");
    require(all_within(&shape_.drawn_scale_px, 1, 0, kMaxDrawnScale_px), "its drawn size is out of range");
    require(is_style(style_), "its style is out of range");
  }

  void check_outline() const {
    const auto& curves = shape_.outline.curves;
    require_length(shape_.perimeter, "its perimeter is out of range");
    require_length(shape_.radius, "its radius is out of range");
    require(!curves.empty() && curves.size() <= kMaxCurvesPerShape, "it has no curve or too many");
    std::size_t points = 0;
    for (const auto& curve : curves) {
      points += curve.size();
      require(curve.size() >= 3 && points <= kMaxPointsPerShape, "a curve has too few points, or all have too many");
      require(all_within(curve.data(), curve.size(), -kMaxCoordinate, kMaxCoordinate), "a point is out of range");
    }
  }

  void check_field() const {
    const Grid<float>& distance = shape_.field.distance;
    require(distance.width() == kFieldNodes && distance.height() == kFieldNodes, "its field has another size");
    require_length(shape_.field.extent, "its field's extent is out of range");
    require(all_within(distance.data().data(), distance.data().size(), -kMaxCoordinate, kMaxCoordinate),
            "a distance is out of range");
  }

  void check_level(const LevelCurve& level, const SmoothingLevel& expected) const {
    require(level.points.size() == std::size_t(expected.curve_points) &&
                level.samples.size() == std::size_t(expected.samples),
            "a smoothing level has other points or samples");
    require_length(level.perimeter, "a smoothed perimeter is out of range");
    require(all_within(level.points.data(), level.points.size(), -kMaxCoordinate, kMaxCoordinate),
            "a point is out of range");
    for (const ArclengthPyramid& sample : level.samples) {
      require(all_within(sample.left.data(), kMaxPadLevels, 0, kMaxCoordinate) &&
                  all_within(sample.right.data(), kMaxPadLevels, 0, kMaxCoordinate) &&
                  all_within(sample.keypoint.data(), sample.keypoint.size(), -kMaxCoordinate, kMaxCoordinate) &&
                  all_within(&sample.convexity, 1, -1, 1),
              "a sample is out of range");
    }
  }

  void check_artwork() const {
    const Artwork& artwork = shape_.artwork;
    require(std::min(artwork.width_px, artwork.height_px) > 0 &&
                std::max(artwork.width_px, artwork.height_px) <= kMaxArtworkSize_px,
            "its raster's size is out of range");
    require(all_within(&artwork.centroid_px, 1, -kMaxArtworkSize_px, kMaxArtworkSize_px),
            "its centroid is out of range");
    require(all_within(&artwork.unit_px, 1, kLeastLength, kMaxArtworkSize_px), "its unit is out of range");
    require(artwork.thumbnail_png.size() <= kMaxThumbnailBytes, "its thumbnail is too large");
    require(artwork.thumbnail_png.empty() || is_thumbnail_png(artwork.thumbnail_png),
            "its thumbnail is not a PNG of 192 px or less");
    require(artwork.original.size() <= kMaxOriginalBytes, "its artwork is too large to embed");
    require(artwork.surroundings_png.size() <= kMaxSurroundingsBytes, "its surroundings are too large");
    require(artwork.surroundings_margin_px >= 0 && artwork.surroundings_margin_px <= kMaxSurroundingsMargin_px,
            "the margin of its surroundings is out of range");
  }

  const Shape& shape_;
  const StyleFeatures& style_;
};

}  // namespace

bool all_within(const float* values, std::size_t count, float least, float most) {
  // NaN fails both comparisons.
  return std::all_of(values, values + count, [&](float v) { return v >= least && v <= most; });
}

bool all_within(const Vec2* values, std::size_t count, float least, float most) {
  return std::all_of(values, values + count,
                     [&](Vec2 v) { return v.x >= least && v.x <= most && v.y >= least && v.y <= most; });
}

bool is_style(const StyleFeatures& style) {
  const float parts[] = {style.line_width, style.line_part, style.outlined, style.shading, style.detail};
  const float colours[] = {style.chroma, style.texture};
  return all_within(parts, std::size(parts), 0, 1) && all_within(colours, std::size(colours), 0, kMaxLab) &&
         all_within(&style.palette, 1, -1, kMostPaletteBits);
}

void check_fits_library(const Shape& shape, const StyleFeatures& style) { ShapeCheck(shape, style).all(); }

}  // namespace tessera
