#include "core/quality/boundary_grid.h"

#include <algorithm>
#include <cmath>

namespace tessera {
namespace {

constexpr float kMostBuckets = 1 << 24;
constexpr float kSpacing_px = 0.5f;  // of boundary samples; a distance of 2 px has an error of at most 0.016 px

bool of_earlier_piece(const EdgeSample& a, const EdgeSample& b) { return a.piece < b.piece; }

void append_curve(const std::vector<Vec2>& curve_px, std::uint32_t piece, std::vector<EdgeSample>& samples) {
  float until_next = 0;  // length left before the next sample
  for (std::size_t i = 0; i < curve_px.size(); ++i) {
    const Vec2 p = curve_px[i];
    const Vec2 edge = curve_px[(i + 1) % curve_px.size()] - p;
    const float length = norm(edge);
    float at = until_next;
    for (; at < length; at += kSpacing_px) samples.push_back({p + edge * (at / length), piece});
    until_next = at - length;
  }
}

/// Moves the samples into the first period and adds the images within reach of it. The result is in the order of the
/// pieces.
void cross_seams(const Canvas& canvas, float reach_px, std::vector<EdgeSample>& samples) {
  const float far_x = float(canvas.width_px) + reach_px;
  const float far_y = float(canvas.height_px) + reach_px;
  for (EdgeSample& s : samples) s.position_px = canvas.period.wrapped(s.position_px);
  const std::size_t count = samples.size();
  for (const Vec2 offset : canvas.period.offsets()) {
    if (offset == Vec2{}) continue;
    for (std::size_t i = 0; i < count; ++i) {
      const Vec2 p = samples[i].position_px + offset;
      if (p.x > -reach_px && p.x < far_x && p.y > -reach_px && p.y < far_y)
        samples.push_back({p, samples[i].piece, true});
    }
  }
  if (samples.size() > count) std::stable_sort(samples.begin(), samples.end(), of_earlier_piece);
}

/// The width of a bucket: the reach, or more if there would be too many buckets.
float bucket_width_px(Vec2 extent_px, float reach_px) {
  return std::max(reach_px, std::sqrt(extent_px.x / kMostBuckets * extent_px.y));
}

}  // namespace

std::vector<EdgeSample> edge_samples(const Canvas& canvas, const std::vector<JudgedPiece>& pieces, float reach_px) {
  std::vector<EdgeSample> samples;
  for (std::uint32_t piece = 0; piece < pieces.size(); ++piece) {
    for (const std::vector<Vec2>& curve : pieces[piece].outline_px.curves) append_curve(curve, piece, samples);
  }
  cross_seams(canvas, reach_px, samples);
  return samples;
}

BoundaryGrid::BoundaryGrid(const std::vector<EdgeSample>& samples, float reach_px) : reach_px_(reach_px) {
  low_px_ = samples.front().position_px;
  Vec2 high_px = low_px_;
  for (const EdgeSample& s : samples) {
    low_px_ = {std::min(low_px_.x, s.position_px.x), std::min(low_px_.y, s.position_px.y)};
    high_px = {std::max(high_px.x, s.position_px.x), std::max(high_px.y, s.position_px.y)};
  }
  const Vec2 extent_px = high_px - low_px_;
  bucket_px_ = bucket_width_px(extent_px, reach_px);
  first_ = {int(extent_px.x / bucket_px_) + 1, int(extent_px.y / bucket_px_) + 1};
  std::vector<std::uint32_t> size(first_.data().size() + 1, 0);
  for (const EdgeSample& s : samples) ++size[bucket_of(s.position_px)];
  std::uint32_t begin = 0;
  for (std::size_t i = 0; i < first_.data().size(); ++i) {
    first_.data()[i] = begin;
    begin += size[i];
  }
  sorted_.resize(samples.size());
  std::vector<std::uint32_t> next = first_.data();
  for (const EdgeSample& s : samples) sorted_[next[bucket_of(s.position_px)]++] = s;
}

int BoundaryGrid::column_of(Vec2 p) const {
  return std::clamp(int((p.x - low_px_.x) / bucket_px_), 0, first_.width() - 1);
}
int BoundaryGrid::row_of(Vec2 p) const {
  return std::clamp(int((p.y - low_px_.y) / bucket_px_), 0, first_.height() - 1);
}

template <class F>
bool BoundaryGrid::any_of_others(std::size_t bucket, std::uint32_t piece, F f) const {
  const auto begin = sorted_.begin() + first_.data()[bucket];
  const auto end = bucket + 1 < first_.data().size() ? sorted_.begin() + first_.data()[bucket + 1] : sorted_.end();
  const auto [own, behind] = std::equal_range(begin, end, EdgeSample{{}, piece}, of_earlier_piece);
  return std::any_of(begin, own, f) || std::any_of(behind, end, f);
}

bool BoundaryGrid::another_piece_near(const EdgeSample& sample) const {
  const auto near = [&](const EdgeSample& other) {
    const Vec2 d = other.position_px - sample.position_px;
    return dot(d, d) <= reach_px_ * reach_px_;
  };
  const int cx = column_of(sample.position_px);
  const int cy = row_of(sample.position_px);
  // Mostly the sample's own bucket gives the answer.
  if (any_of_others(std::size_t(cy) * first_.width() + cx, sample.piece, near)) return true;
  for (int y = std::max(0, cy - 1); y <= std::min(first_.height() - 1, cy + 1); ++y) {
    for (int x = std::max(0, cx - 1); x <= std::min(first_.width() - 1, cx + 1); ++x) {
      if (any_of_others(std::size_t(y) * first_.width() + x, sample.piece, near)) return true;
    }
  }
  return false;
}

float BoundaryGrid::distance_to_another_px(Vec2 position_px, std::uint32_t piece) const {
  float least_px2 = reach_px_ * reach_px_;
  const auto measure = [&](const EdgeSample& other) {
    const Vec2 d = other.position_px - position_px;
    least_px2 = std::min(least_px2, dot(d, d));
    return false;
  };
  const int cx = column_of(position_px);
  const int cy = row_of(position_px);
  for (int y = std::max(0, cy - 1); y <= std::min(first_.height() - 1, cy + 1); ++y) {
    for (int x = std::max(0, cx - 1); x <= std::min(first_.width() - 1, cx + 1); ++x) {
      any_of_others(std::size_t(y) * first_.width() + x, piece, measure);
    }
  }
  return std::sqrt(least_px2);
}

}  // namespace tessera
