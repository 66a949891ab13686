#include "core/recognition/arc_signature.h"

#include <algorithm>
#include <cmath>

namespace tessera {
namespace {

static_assert(2 * (kArcPoints - 1) == kMaxPadElements);
/// A sum of directions shorter than this fraction of a straight line's gives no direction.
constexpr float kLeastDirection = 0.1f;
constexpr std::uint8_t kAnySign = 3;

}  // namespace

std::optional<ArcSignature> arc_signature(const ArcPoints& points, float length) {
  if (!(length > 0)) return std::nullopt;
  Vec2 mean;
  for (const Vec2 p : points) mean = mean + p * (1.f / kArcPoints);
  Vec2 direction;
  float straight = 0;
  for (int i = 0; i < kArcPoints; ++i) {
    const float along = float(i) / (kArcPoints - 1) - 0.5f;
    direction = direction + (points[std::size_t(i)] - mean) * (along / length);
    straight += along * along;
  }
  if (norm(direction) < kLeastDirection * straight) return std::nullopt;
  const Vec2 axis = direction * (1 / norm(direction));
  ArcSignature signature{};
  for (std::size_t i = 0; i + 1 < kArcPoints; ++i) {
    const Vec2 p = (points[i] - mean) * (1 / length);
    signature[2 * i] = 0.5f + dot(p, axis);
    signature[2 * i + 1] = 0.5f + cross(axis, p);
  }
  return signature;
}

float arc_distance(const ArcSignature& a, const ArcSignature& b) {
  float largest = 0;
  for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, std::abs(a[i] - b[i]));
  return largest;
}

PadBytes arc_bytes(const std::optional<ArcSignature>& signature, float length) {
  PadBytes bytes;
  bytes.sign = kAnySign;
  if (!signature) return bytes;  // all elements 0: far from every signature, whose elements are about 1/2
  for (std::size_t i = 0; i < signature->size(); ++i) {
    bytes.element[i] = std::uint8_t(std::clamp((*signature)[i] * 256, 0.f, 255.f));
  }
  bytes.scale = scale_byte(length);
  return bytes;
}

PadTarget arc_target(const ArcSignature& signature, float least, float most) {
  PadTarget target;
  target.left_levels = kMaxPadLevels;
  target.right_levels = kMaxPadLevels;
  // The elements of a PAD's left side come outermost first.
  constexpr std::size_t kSide = kMaxPadElements / 2;
  for (std::size_t i = 0; i < kSide; ++i) {
    target.left[i] = signature[kSide - 1 - i];
    target.right[i] = signature[kSide + i];
  }
  target.sign = kAnySign;
  target.scales = scale_window(least, most);
  return target;
}

}  // namespace tessera
