#include "products/texture/texture_pieces.h"

#include <cmath>

#include "products/puzzle/puzzle_geojson.h"

namespace tessera {
namespace {

/// The pose of a shape where its element lies in the photo, moved by whole px, so that its pixels stay what they are.
Similarity pose_of(const ElementShape& element, cv::Point shift_px) {
  const Artwork& artwork = element.shape.artwork;
  const float photo_px =
      float(element.element.box.width + 2 * kElementRim_px) / float(artwork.width_px);  // of an artwork px
  const cv::Point corner = element.element.box.tl() - cv::Point(kElementRim_px, kElementRim_px) + shift_px;
  return {artwork.unit_px * photo_px, 0, float(corner.x) + artwork.centroid_px.x * photo_px,
          float(corner.y) + artwork.centroid_px.y * photo_px};
}

/// The pose in that period which holds the shape's centre.
Similarity within(Similarity pose, cv::Size period_px) {
  pose.tx -= float(period_px.width) * std::floor(pose.tx / float(period_px.width));
  pose.ty -= float(period_px.height) * std::floor(pose.ty / float(period_px.height));
  return pose;
}

}  // namespace

std::string texture_pieces(const std::vector<LaidElement>& layout, const std::vector<ElementShape>& elements,
                           cv::Size canvas_px) {
  std::vector<LaidPuzzlePiece> pieces;
  for (const LaidElement& laid : layout) {
    const ElementShape& element = elements[laid.element];
    const Similarity pose = within(pose_of(element, laid.shift_px), canvas_px);
    pieces.push_back({element.shape.name, pose, {}});
    for (const Vec2 p : element.shape.outline.curves.front()) pieces.back().outline_px.push_back(pose.apply(p));
  }
  return puzzle_geojson(pieces);
}

}  // namespace tessera
