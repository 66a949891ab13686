#include "core/shape/shape_contradiction.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "core/base/portable_math.h"
#include "core/geometry/closed_curve.h"
#include "core/geometry/polygon.h"
#include "core/shape/outline.h"

namespace tessera {
namespace {

constexpr float kRoundedLength = 1e-3f;    // fraction of a length that summation may lose
constexpr double kRoundedArea = 0.02;      // tolerance of the area, which is 1
constexpr float kRoundedDistance = 2e-3f;  // shape units; the library's steps are finer (docs/library-format.md)
constexpr int kCheckedBlock = 8;           // nodes in each direction of a block in which one node is computed again

bool agree(float a, float b) { return std::abs(a - b) <= kRoundedLength * std::max(1.f, std::abs(b)); }

/// Calls visit(from, to) for every side of every curve.
template <class Visit>
void each_side(const Outline& outline, Visit visit) {
  for (const std::vector<Vec2>& curve : outline.curves) {
    for (std::size_t i = 0, j = curve.size() - 1; i < curve.size(); j = i++) visit(curve[j], curve[i]);
  }
}

float distance_to(const Outline& outline, Vec2 p) {
  float squared = std::numeric_limits<float>::max();
  each_side(outline, [&](Vec2 from, Vec2 to) {
    const Vec2 side = to - from;
    const float t = std::clamp(dot(p - from, side) / std::max(dot(side, side), 1e-20f), 0.f, 1.f);
    const Vec2 rest = p - from - side * t;
    squared = std::min(squared, dot(rest, rest));
  });
  return std::sqrt(squared);
}

/// Checks of a field against its outline.
class FieldCheck {
 public:
  explicit FieldCheck(const Shape& shape)
      : outline_(shape.outline),
        field_(shape.field),
        nodes_(shape.field.distance.width()),
        spacing_(2 * shape.field.extent / float(nodes_ - 1)) {}

  bool covers_outline() const {
    for (const std::vector<Vec2>& curve : outline_.curves) {
      for (const Vec2 p : curve) {
        if (std::max(std::abs(p.x), std::abs(p.y)) > field_.extent) return false;
      }
    }
    return true;
  }

  /// Whether neighbouring values differ by at most the distance of the nodes.
  bool is_smooth() const {
    const float most = spacing_ + kRoundedDistance;
    for (int y = 0; y < nodes_; ++y) {
      for (int x = 0; x < nodes_; ++x) {
        const float d = field_.distance(x, y);
        if (x > 0 && !(std::abs(d - field_.distance(x - 1, y)) <= most)) return false;
        if (y > 0 && !(std::abs(d - field_.distance(x, y - 1)) <= most)) return false;
      }
    }
    return true;
  }

  /// Whether the field is near 0 at every point of the outline: at most a cell's diagonal.
  bool is_zero_on_outline() const {
    const float most = std::numbers::sqrt2_v<float> * spacing_ + kRoundedDistance;
    for (const std::vector<Vec2>& curve : outline_.curves) {
      for (const Vec2 p : curve) {
        if (!(std::abs(field_.at(p)) <= most)) return false;
      }
    }
    return true;
  }

  /// Whether nodes inside by the even-odd rule are negative and the others positive, except nodes on the outline.
  bool has_right_signs() const {
    const std::vector<std::vector<float>> crossings = crossings_of_rows();
    for (int y = 0; y < nodes_; ++y) {
      std::size_t passed = 0;
      for (int x = 0; x < nodes_; ++x) {
        while (passed < crossings[y].size() && crossings[y][passed] < node(x)) ++passed;
        const float d = field_.distance(x, y);
        if (std::abs(d) > kRoundedDistance && (d < 0) != (passed % 2 != 0)) return false;
      }
    }
    return true;
  }

  bool is_exact_here_and_there() const {
    std::uint64_t key = std::bit_cast<std::uint32_t>(field_.extent);
    for (int y = 0; y + kCheckedBlock <= nodes_; y += kCheckedBlock) {
      for (int x = 0; x + kCheckedBlock <= nodes_; x += kCheckedBlock) {
        key = mix_bits(key ^ std::bit_cast<std::uint32_t>(field_.distance(x, y)));
        const int i = x + int(key % kCheckedBlock);
        const int j = y + int(key / kCheckedBlock % kCheckedBlock);
        const float found = std::abs(field_.distance(i, j));
        if (!(std::abs(found - distance_to(outline_, {node(i), node(j)})) <= kRoundedDistance)) return false;
      }
    }
    return true;
  }

 private:
  float node(int i) const { return field_.extent * (2 * float(i) / float(nodes_ - 1) - 1); }

  /// The points where each row's line enters and leaves the outline, ascending.
  std::vector<std::vector<float>> crossings_of_rows() const {
    std::vector<std::vector<float>> crossings(field_.distance.data().size() / std::size_t(nodes_));
    each_side(outline_, [&](Vec2 from, Vec2 to) {
      const auto row = [&](float y) { return std::clamp(int((y + field_.extent) / spacing_), 0, nodes_ - 1); };
      const auto [low, high] = std::minmax({row(from.y), row(to.y)});
      for (int y = std::max(0, low - 1); y <= std::min(nodes_ - 1, high + 1); ++y) {
        if ((from.y > node(y)) == (to.y > node(y))) continue;
        crossings[y].push_back(from.x + (to.x - from.x) * ((node(y) - from.y) / (to.y - from.y)));
      }
    });
    for (std::vector<float>& row : crossings) std::sort(row.begin(), row.end());
    return crossings;
  }

  const Outline& outline_;
  const ShapeField& field_;
  int nodes_;
  float spacing_;
};

}  // namespace

std::string shape_contradiction(const Shape& shape) {
  const FieldCheck field(shape);
  float radius = 0;
  for (const Vec2 p : shape.outline.curves.front()) radius = std::max(radius, norm(p));
  if (!(std::abs(area_moment(shape.outline).area - 1) <= kRoundedArea)) return "its outline's area is not 1";
  if (!agree(shape.perimeter, perimeter_of(shape.outline))) return "its perimeter is not its outline's";
  if (!agree(shape.radius, radius)) return "its radius is not its outline's";
  if (!field.covers_outline() || !field.is_smooth() || !field.is_zero_on_outline() || !field.has_right_signs() ||
      !field.is_exact_here_and_there())
    return "its distance field is not its outline's";
  return {};
}

}  // namespace tessera
