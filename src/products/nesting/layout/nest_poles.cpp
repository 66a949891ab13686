#include "products/nesting/layout/nest_poles.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tessera {
namespace {

constexpr int kNodes = 48;        // of the grid along the longer side of the box
constexpr double kCovered = 0.9;  // part of the area that all discs cover
constexpr double kLeast = 0.05;   // least radius, as a part of the largest disc's

/// The radius of the largest disc round p.
double room(const NestRing& ring, const std::vector<NestPole>& poles, NestPoint p) {
  if (!contains(ring, p)) return -1;
  double room = distance_to_boundary(ring, p);
  for (const NestPole& pole : poles) room = std::min(room, norm(p - pole.centre) - pole.radius);
  return room;
}

/// Moves the disc to where there is more room, in halved steps.
NestPole climbed(const NestRing& ring, const std::vector<NestPole>& poles, NestPole pole, double step) {
  for (int halvings = 0; halvings < 12;) {
    bool moved = false;
    for (const NestPoint way : {NestPoint{step, 0}, NestPoint{-step, 0}, NestPoint{0, step}, NestPoint{0, -step}}) {
      const double there = room(ring, poles, pole.centre + way);
      if (!(there > pole.radius)) continue;
      pole = {pole.centre + way, there};
      moved = true;
    }
    if (moved) continue;
    step /= 2;
    ++halvings;
  }
  return pole;
}

struct Node {
  NestPoint at;
  double room;
};

std::vector<Node> nodes_inside(const NestRing& ring, double step) {
  const NestBox box = box_of(ring);
  std::vector<Node> nodes;
  for (double y = box.low.y + step / 2; y < box.high.y; y += step) {
    for (double x = box.low.x + step / 2; x < box.high.x; x += step) {
      if (const double here = room(ring, {}, {x, y}); here > 0) nodes.push_back({{x, y}, here});
    }
  }
  return nodes;
}

}  // namespace

std::vector<NestPole> poles_of(const NestRing& ring, int most) {
  const NestBox box = box_of(ring);
  double step = std::max(box.width(), box.height()) / kNodes;
  std::vector<Node> nodes = nodes_inside(ring, step);
  // Each halving costs four times as much; thinner shapes are handled at the end.
  for (int finer = 0; nodes.empty() && finer < 2; ++finer) nodes = nodes_inside(ring, step /= 2);
  std::vector<NestPole> poles;
  double left = kCovered * std::abs(signed_area(ring));
  while (int(poles.size()) < most && left > 0 && !nodes.empty()) {
    const auto widest =
        std::max_element(nodes.begin(), nodes.end(), [](const Node& a, const Node& b) { return a.room < b.room; });
    if (!(widest->room > 0)) break;
    const NestPole pole = climbed(ring, poles, {widest->at, widest->room}, step / 2);
    if (!poles.empty() && pole.radius < kLeast * poles.front().radius) break;
    poles.push_back(pole);
    left -= std::numbers::pi * pole.radius * pole.radius;
    for (Node& node : nodes) node.room = std::min(node.room, norm(node.at - pole.centre) - pole.radius);
  }
  if (poles.empty()) {  // thinner than the grid sees: takes the middle of a diagonal
    for (std::size_t i = 0; i < ring.size() && poles.empty(); ++i) {
      const NestPoint middle = (ring[i] + ring[(i + 1) % ring.size()] + ring[(i + 2) % ring.size()]) * (1.0 / 3);
      if (contains(ring, middle)) poles.push_back({middle, distance_to_boundary(ring, middle)});
    }
    if (poles.empty()) poles.push_back({ring.front(), 0});
  }
  return poles;
}

}  // namespace tessera
