#include "core/recognition/point_fit.h"

#include <algorithm>
#include <cmath>

namespace tessera {
namespace {

Vec2 mean_of(std::span<const Vec2> points) {
  Vec2 sum;
  for (const Vec2 p : points) sum = sum + p;
  return sum * (1 / float(points.size()));
}

}  // namespace

PointFit fit_points(std::span<const Vec2> shape, std::span<const Vec2> query) {
  const Vec2 shape_mean = mean_of(shape);
  const Vec2 query_mean = mean_of(query);
  Vec2 product;
  float shape_spread = 0;
  float query_spread = 0;
  for (std::size_t i = 0; i < shape.size(); ++i) {
    const Vec2 s = shape[i] - shape_mean;
    const Vec2 q = query[i] - query_mean;
    product.x += dot(s, q);
    product.y += cross(s, q);
    shape_spread += dot(s, s);
    query_spread += dot(q, q);
  }
  PointFit fit;
  if (!(shape_spread > 0) || !(query_spread > 0)) {
    fit.residual = 1;
    return fit;
  }
  Similarity& pose = fit.query_from_shape;
  pose.a = product.x / shape_spread;
  pose.b = product.y / shape_spread;
  pose.tx = query_mean.x - (pose.a * shape_mean.x - pose.b * shape_mean.y);
  pose.ty = query_mean.y - (pose.b * shape_mean.x + pose.a * shape_mean.y);
  fit.residual = std::sqrt(std::max(0.f, 1 - dot(product, product) / (shape_spread * query_spread)));
  return fit;
}

}  // namespace tessera
