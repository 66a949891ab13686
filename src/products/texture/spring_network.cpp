#include "products/texture/spring_network.h"

namespace tessera {
namespace {

using Vectors = std::vector<cv::Vec2d>;

/// The stiffness by which a point is held in its place.
constexpr double kHold = 0.05;
constexpr int kMostSteps = 60;
constexpr double kLeastForce = 1e-9;  // the square of all forces

double dot(const Vectors& a, const Vectors& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i].dot(b[i]);
  return sum;
}

/// The forces against these ways, without pulls.
Vectors resistance(const std::vector<Spring>& springs, const Vectors& ways) {
  Vectors forces(ways.size());
  for (std::size_t i = 0; i < ways.size(); ++i) forces[i] = kHold * ways[i];
  for (const Spring& spring : springs) {
    const cv::Vec2d force = spring.stiffness * (ways[spring.second] - ways[spring.first]);
    forces[spring.second] += force;
    forces[spring.first] -= force;
  }
  return forces;
}

/// The forces where no point has gone yet.
Vectors first_forces(const std::vector<Spring>& springs, const Vectors& moved) {
  Vectors forces(moved.size());
  for (std::size_t i = 0; i < moved.size(); ++i) forces[i] = -kHold * moved[i];
  for (const Spring& spring : springs) {
    forces[spring.second] -= spring.pull;
    forces[spring.first] += spring.pull;
  }
  return forces;
}

}  // namespace

// The equations are solved by conjugate gradients.
std::vector<cv::Vec2d> ways_at_rest(const std::vector<Spring>& springs, const std::vector<cv::Vec2d>& moved) {
  Vectors ways(moved.size()), forces = first_forces(springs, moved), direction = forces;
  double square = dot(forces, forces);
  for (int step = 0; step < kMostSteps && square > kLeastForce; ++step) {
    const Vectors change = resistance(springs, direction);
    const double length = square / dot(direction, change);
    for (std::size_t i = 0; i < ways.size(); ++i) {
      ways[i] += length * direction[i];
      forces[i] -= length * change[i];
    }
    const double next = dot(forces, forces);
    for (std::size_t i = 0; i < ways.size(); ++i) direction[i] = forces[i] + next / square * direction[i];
    square = next;
  }
  return ways;
}

}  // namespace tessera
