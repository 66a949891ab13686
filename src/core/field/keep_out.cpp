#include "core/field/keep_out.h"

#include <algorithm>
#include <cmath>

namespace tessera {
namespace {

/// Images farther beyond the canvas' edge than this make no difference that fields can show.
constexpr int kMostBeyond_px = 512;

CanvasField nodes_of(const Canvas& canvas) {
  const Grid<float>& own = canvas.distance.value;
  return {Grid<float>(own.width(), own.height()), canvas.distance.origin};
}

int beyond_px(int period_px) { return std::min(period_px / 2, kMostBeyond_px); }

/// The coverage with `beyond` cells of its images around it.
Grid<float> repeated(const Grid<float>& coverage, int beyond_x, int beyond_y) {
  Grid<float> wide(coverage.width() + 2 * beyond_x, coverage.height() + 2 * beyond_y);
  for (int y = 0; y < wide.height(); ++y) {
    const float* from = coverage.row((y - beyond_y + coverage.height()) % coverage.height());
    for (int x = 0; x < wide.width(); ++x) wide(x, y) = from[(x - beyond_x + coverage.width()) % coverage.width()];
  }
  return wide;
}

void take_out(const Grid<float>& zones, Grid<float>& distance) {
  for (std::size_t i = 0; i < distance.data().size(); ++i) {
    distance.data()[i] = std::min(distance.data()[i], zones.data()[i]);
  }
}

}  // namespace

float distance_px(const KeepOutRectangle& zone, Vec2 canvas_px) {
  const float corner_px = std::min({zone.corner_px, zone.half_size_px.x, zone.half_size_px.y});
  const Vec2 from_middle = canvas_px - zone.middle_px;
  const Vec2 down{-zone.across.y, zone.across.x};
  const float x = std::abs(dot(from_middle, zone.across)) - zone.half_size_px.x + corner_px;
  const float y = std::abs(dot(from_middle, down)) - zone.half_size_px.y + corner_px;
  const Vec2 outside{std::max(x, 0.f), std::max(y, 0.f)};
  return norm(outside) + std::min(std::max(x, y), 0.f) - corner_px;
}

namespace {

constexpr int kBlock_px = 16;

/// The zones that are the nearest to some node of the block, and few others. A zone's distance changes by no more than
/// the distance from the block's middle.
std::vector<KeepOutRectangle> nearest_to_any_of(const std::vector<KeepOutRectangle>& zones, const Window& block,
                                                Vec2 origin) {
  constexpr float kReach_px = 0.75f * kBlock_px;  // more than half the diagonal
  const Vec2 middle = origin + Vec2{float(block.x0 + block.x1), float(block.y0 + block.y1)} * 0.5f;
  std::vector<float> distances_px;
  float least_px = kNoEdge_px;
  for (const KeepOutRectangle& zone : zones) {
    distances_px.push_back(distance_px(zone, middle));
    least_px = std::min(least_px, distances_px.back());
  }
  std::vector<KeepOutRectangle> nearest;
  for (std::size_t i = 0; i < zones.size(); ++i) {
    if (distances_px[i] <= least_px + 2 * kReach_px) nearest.push_back(zones[i]);
  }
  return nearest;
}

void write_nearest(const std::vector<KeepOutRectangle>& zones, const Window& block, CanvasField& distance) {
  for (int y = block.y0; y < block.y1; ++y) {
    for (int x = block.x0; x < block.x1; ++x) {
      float nearest = kNoEdge_px;
      for (const KeepOutRectangle& zone : zones) {
        nearest = std::min(nearest, distance_px(zone, distance.origin + Vec2{float(x), float(y)}));
      }
      distance.value(x, y) = nearest;
    }
  }
}

}  // namespace

CanvasField distance_to(const std::vector<KeepOutRectangle>& zones, const Canvas& canvas) {
  std::vector<KeepOutRectangle> images;
  for (KeepOutRectangle zone : zones) {
    zone.middle_px = canvas.period.wrapped(zone.middle_px);
    for (const Vec2 offset : canvas.period.offsets()) {
      images.push_back(zone);
      images.back().middle_px = zone.middle_px + offset;
    }
  }
  CanvasField distance = nodes_of(canvas);
  for (int y = 0; y < distance.value.height(); y += kBlock_px) {
    for (int x = 0; x < distance.value.width(); x += kBlock_px) {
      const Window block{x, y, std::min(x + kBlock_px, distance.value.width()),
                         std::min(y + kBlock_px, distance.value.height())};
      write_nearest(nearest_to_any_of(images, block, distance.origin), block, distance);
    }
  }
  return distance;
}

CanvasField distance_to(const Grid<float>& coverage, const Canvas& canvas) {
  const int beyond_x = beyond_px(canvas.period.x_px);
  const int beyond_y = beyond_px(canvas.period.y_px);
  const Canvas zones = make_mask_canvas(repeated(coverage, 2 * beyond_x, 2 * beyond_y));
  CanvasField distance = nodes_of(canvas);
  for (int y = 0; y < distance.value.height(); ++y) {
    for (int x = 0; x < distance.value.width(); ++x) {
      distance.value(x, y) = -zones.distance.value(x + beyond_x, y + beyond_y);
    }
  }
  return distance;
}

void take_out(const CanvasField& zones, Canvas& canvas) {
  if (canvas.keep_out.value.data().empty()) {
    canvas.keep_out = zones;
  } else {
    take_out(zones.value, canvas.keep_out.value);
  }
  take_out(zones.value, canvas.distance.value);
  canvas.area_px2 = area_px2(canvas.distance, canvas.width_px, canvas.height_px);
  for (CanvasRegion& region : canvas.regions) {
    take_out(zones.value, region.distance.value);
    region.area_px2 = area_px2(region.distance, canvas.width_px, canvas.height_px);
  }
}

}  // namespace tessera
