#include "core/replacing/window_edge.h"

#include <algorithm>
#include <cmath>

#include "core/relax/edge_distance.h"
#include "core/relax/schedules.h"

namespace tessera {
namespace {

constexpr float kLeastEdgeNode_px = 2;
constexpr float kEdgeNodesPerScale = 32;  // of the least scale: large pieces need no finer edge
// holes look no farther; contacts do if pieces keep a larger distance from the edge
constexpr float kFarFromEdge_px = 64;

/// Fills those of these nodes that are nearer to the edge than `far_px`, and returns whether there are any. Halves a
/// block of nodes that may contain both kinds: a raster of all nodes would be most of the master's work.
bool fill_near_edge(const EdgeDistance& canvas, const Window& nodes, float far_px, EdgeField& edge) {
  const auto at = [&](float x, float y) { return canvas.at((edge.distance.origin + Vec2{x, y}) * edge.node_px).value; };
  const Vec2 half{0.5f * float(nodes.x1 - nodes.x0 - 1), 0.5f * float(nodes.y1 - nodes.y0 - 1)};
  const float middle_px = at(float(nodes.x0) + half.x, float(nodes.y0) + half.y);
  if (middle_px - norm(half) * edge.node_px > far_px) return false;
  constexpr int kSmall = 8;
  if (nodes.x1 - nodes.x0 > kSmall || nodes.y1 - nodes.y0 > kSmall) {
    const bool wide = half.x > half.y;
    const int x = wide ? (nodes.x0 + nodes.x1) / 2 : nodes.x1, y = wide ? nodes.y1 : (nodes.y0 + nodes.y1) / 2;
    const bool first = fill_near_edge(canvas, {nodes.x0, nodes.y0, x, y}, far_px, edge);
    const bool second =
        fill_near_edge(canvas, {wide ? x : nodes.x0, wide ? nodes.y0 : y, nodes.x1, nodes.y1}, far_px, edge);
    return first || second;
  }
  bool any = false;
  for (int y = nodes.y0; y < nodes.y1; ++y) {
    for (int x = nodes.x0; x < nodes.x1; ++x) {
      float& value = edge.distance.value(x, y);
      value = std::min(far_px, at(float(x), float(y)));
      any = any || value < far_px;
    }
  }
  return any;
}

}  // namespace

EdgeField edge_around(const Box& box, const FreeField& free, const PieceSettings& pieces) {
  const Vec2 beyond{pieces.max_scale_px, pieces.max_scale_px};
  const Box seen{box.low - beyond, box.high + beyond};
  const EdgeDistance canvas(free);
  const float node_px = std::max(kLeastEdgeNode_px, pieces.min_scale_px / kEdgeNodesPerScale);
  const auto node = [node_px](float at_px) { return int(std::floor(at_px / node_px)); };
  const int x0 = node(seen.low.x), x1 = node(seen.high.x) + 2;
  const int y0 = node(seen.low.y), y1 = node(seen.high.y) + 2;
  const float far_px = std::max(kFarFromEdge_px, contact_distances(pieces).reach_px() + 4 * node_px);
  EdgeField edge{{Grid<float>(x1 - x0, y1 - y0, far_px), {float(x0), float(y0)}}, node_px};
  if (fill_near_edge(canvas, {0, 0, x1 - x0, y1 - y0}, far_px, edge)) return edge;
  // Most windows of a large canvas: nothing in them is affected by the edge.
  const float across_px = std::max(seen.width(), seen.height());
  return {{Grid<float>(3, 3, kNoEdge_px), seen.low * (1 / across_px)}, across_px};
}

}  // namespace tessera
