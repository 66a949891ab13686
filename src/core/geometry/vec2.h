// A point or direction of the plane. The name of the variable tells the frame (canvas, shape, field node).
#pragma once

#include <cmath>

namespace tessera {

struct Vec2 {
  float x = 0;
  float y = 0;

  friend bool operator==(const Vec2&, const Vec2&) = default;
};

inline Vec2 operator+(Vec2 a, Vec2 b) { return {a.x + b.x, a.y + b.y}; }
inline Vec2 operator-(Vec2 a, Vec2 b) { return {a.x - b.x, a.y - b.y}; }
inline Vec2 operator*(Vec2 a, float k) { return {a.x * k, a.y * k}; }
inline float dot(Vec2 a, Vec2 b) { return a.x * b.x + a.y * b.y; }
/// The z component of a × b: positive where b lies on the left of a (abstract plane; on a canvas with y down: right).
inline float cross(Vec2 a, Vec2 b) { return a.x * b.y - a.y * b.x; }
inline float norm(Vec2 a) { return std::sqrt(dot(a, a)); }

}  // namespace tessera
