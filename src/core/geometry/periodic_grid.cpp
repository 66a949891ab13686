#include "core/geometry/periodic_grid.h"

namespace tessera {
namespace {

struct NodeRun {
  int begin;
  int end;
};

int floor_of(int a, int b) { return a / b - (a % b < 0 ? 1 : 0); }

/// The parts of the images of [begin, end) that lie in `bounds`.
std::vector<NodeRun> runs(NodeRun run, int period, NodeRun bounds) {
  std::vector<NodeRun> parts;
  const auto add = [&](int begin, int end) {
    const NodeRun part{std::max(begin, bounds.begin), std::min(end, bounds.end)};
    if (part.begin < part.end) parts.push_back(part);
  };
  if (run.begin >= run.end) return parts;
  if (period == 0) {
    add(run.begin, run.end);
  } else if (run.end - run.begin >= period) {
    add(bounds.begin, bounds.end);
  } else {
    const int length = run.end - run.begin;
    const int periods = floor_of(bounds.begin - run.begin, period);
    for (int at = run.begin + periods * period; at < bounds.end; at += period) add(at, at + length);
  }
  return parts;
}

bool overlap(NodeRun a, NodeRun b, int period) {
  return period == 0 ? a.begin < b.end && b.begin < a.end : !runs(a, period, b).empty();
}

/// The offset from `b` to its image whose middle is nearest to that of `a`.
int to_nearest(NodeRun a, NodeRun b, int period) {
  if (period == 0) return 0;
  const int apart = (b.begin + b.end) - (a.begin + a.end);  // twice the middles' distance
  return -period * floor_of(apart + period, 2 * period);
}

NodeRun across(const Window& w) { return {w.x0, w.x1}; }
NodeRun down(const Window& w) { return {w.y0, w.y1}; }

}  // namespace

Window PeriodicGrid::clipped(const Window& window) const {
  const Window cut = window.intersected(nodes_);
  const Window& columns = period_.x_px > 0 ? window : cut;
  const Window& rows = period_.y_px > 0 ? window : cut;
  return {columns.x0, rows.y0, columns.x1, rows.y1};
}

std::vector<Window> PeriodicGrid::images(const Window& window, const Window& bounds) const {
  std::vector<Window> parts;
  const std::vector<NodeRun> columns = runs(across(window), period_.x_px, across(bounds));
  for (const NodeRun& rows : runs(down(window), period_.y_px, down(bounds))) {
    for (const NodeRun& run : columns) parts.push_back({run.begin, rows.begin, run.end, rows.end});
  }
  return parts;
}

bool PeriodicGrid::overlap(const Window& a, const Window& b) const {
  return tessera::overlap(across(a), across(b), period_.x_px) && tessera::overlap(down(a), down(b), period_.y_px);
}

Window PeriodicGrid::united(const Window& a, const Window& b) const {
  if (a.empty()) return b;
  if (b.empty()) return a;
  const int dx = to_nearest(across(a), across(b), period_.x_px);
  const int dy = to_nearest(down(a), down(b), period_.y_px);
  return a.united({b.x0 + dx, b.y0 + dy, b.x1 + dx, b.y1 + dy});
}

}  // namespace tessera
