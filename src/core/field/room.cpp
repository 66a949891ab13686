#include "core/field/room.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "core/geometry/rasterise.h"

namespace tessera {
namespace {

// windows up to this side have two cells per px; larger ones have one, to save memory
constexpr int kMostFineSide_px = 2048;

/// A piece at one of its images, and the px of the canvas that it may affect.
struct Image {
  RemovedPiece piece;
  Window window;
};

/// Images whose windows overlap, and the window that contains them.
struct Cluster {
  Window window;
  std::vector<RemovedPiece> pieces;
};

std::vector<Image> images_of(const std::vector<RemovedPiece>& pieces, int beyond_px, const Canvas& canvas) {
  const Window all = Window{0, 0, canvas.width_px, canvas.height_px}.grown(beyond_px + kCanvasMargin);
  std::vector<Image> images;
  for (const RemovedPiece& piece : pieces) {
    for (const Vec2 offset : canvas.period.offsets()) {
      const Similarity at = moved(piece.canvas_from_shape, offset);
      const Window window = bounding_window(*piece.outline, at).grown(beyond_px + 1).intersected(all);
      if (!window.empty()) images.push_back({{piece.outline, at}, window});
    }
  }
  return images;
}

/// Groups the images. A cluster that grows may meet further clusters.
std::vector<Cluster> clusters_of(const std::vector<Image>& images) {
  std::vector<Cluster> clusters;
  for (const Image& image : images) {
    Cluster grown{image.window, {image.piece}};
    for (bool again = true; again;) {
      again = false;
      for (std::size_t i = 0; i < clusters.size(); ++i) {
        if (!clusters[i].window.overlaps(grown.window)) continue;
        grown.window = grown.window.united(clusters[i].window);
        grown.pieces.insert(grown.pieces.end(), clusters[i].pieces.begin(), clusters[i].pieces.end());
        clusters.erase(clusters.begin() + std::ptrdiff_t(i));
        again = true;
        break;
      }
    }
    clusters.push_back(std::move(grown));
  }
  return clusters;
}

/// The area that the cluster's pieces covered, as a canvas of its window's size.
Canvas covered_by(const Cluster& cluster) {
  const Window& w = cluster.window;
  const int cells_per_px = std::max(w.width(), w.height()) <= kMostFineSide_px ? 2 : 1;
  Grid<float> coverage(cells_per_px * w.width(), cells_per_px * w.height(), 0.f);
  for (const RemovedPiece& piece : cluster.pieces) {
    const Similarity in_window = moved(piece.canvas_from_shape, Vec2{-float(w.x0), -float(w.y0)});
    for (const Span& span : fill_spans(*piece.outline, scaled(in_window, float(cells_per_px)), coverage.bounds())) {
      std::fill(coverage.row(span.y) + span.x0, coverage.row(span.y) + span.x1, 1.f);
    }
  }
  return make_mask_canvas(coverage, cells_per_px);
}

/// Adds the cluster's room at the nodes of the canvas.
void add_room(const Cluster& cluster, float beyond_px, Grid<float>& room) {
  const Canvas covered = covered_by(cluster);
  if (covered.area_px2 == 0) return;
  const Window nodes = room.bounds();
  for (int y = cluster.window.y0; y < cluster.window.y1; ++y) {
    for (int x = cluster.window.x0; x < cluster.window.x1; ++x) {
      const int i = x + kCanvasMargin, j = y + kCanvasMargin;
      if (i < 0 || j < 0 || i >= nodes.x1 || j >= nodes.y1) continue;
      const float inside_px = covered.distance.value(i - cluster.window.x0, j - cluster.window.y0);
      room(i, j) = beyond_px + inside_px;
    }
  }
}

}  // namespace

void limit_regions_to_room(const std::vector<RemovedPiece>& pieces, float beyond_px, Canvas& canvas) {
  const Grid<float>& nodes = canvas.distance.value;
  Grid<float> room(nodes.width(), nodes.height(), -1.f);
  for (const Cluster& cluster : clusters_of(images_of(pieces, int(std::ceil(beyond_px)), canvas))) {
    add_room(cluster, beyond_px, room);
  }
  if (canvas.regions.empty()) canvas.regions.push_back({canvas.distance, canvas.area_px2});
  for (CanvasRegion& region : canvas.regions) {
    std::vector<float>& inside_px = region.distance.value.data();
    for (std::size_t i = 0; i < inside_px.size(); ++i) inside_px[i] = std::min(inside_px[i], room.data()[i]);
    region.area_px2 = area_px2(region.distance, canvas.width_px, canvas.height_px);
  }
}

}  // namespace tessera
