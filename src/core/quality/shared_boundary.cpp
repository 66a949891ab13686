#include "core/quality/shared_boundary.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "core/field/field_lookup.h"

namespace tessera {
namespace {

constexpr float kMostBuckets = 1 << 24;
constexpr float kSpacing_px = 0.5f;  // of boundary samples; a distance of 2 px has an error of at most 0.016 px

struct BoundarySample {
  Vec2 position_px;
  std::uint32_t piece;
  bool image = false;  // an image across a seam: near to other pieces, but not part of the counted boundary
};

bool of_earlier_piece(const BoundarySample& a, const BoundarySample& b) { return a.piece < b.piece; }

void append_curve(const std::vector<Vec2>& curve_px, std::uint32_t piece, std::vector<BoundarySample>& samples) {
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
void cross_seams(const Canvas& canvas, float reach_px, std::vector<BoundarySample>& samples) {
  const float far_x = float(canvas.width_px) + reach_px;
  const float far_y = float(canvas.height_px) + reach_px;
  for (BoundarySample& s : samples) s.position_px = canvas.period.wrapped(s.position_px);
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

std::vector<BoundarySample> sample_boundaries(const std::vector<JudgedPiece>& pieces) {
  std::vector<BoundarySample> samples;
  for (std::uint32_t piece = 0; piece < pieces.size(); ++piece) {
    for (const std::vector<Vec2>& curve : pieces[piece].outline_px.curves) append_curve(curve, piece, samples);
  }
  return samples;
}

/// The width of a bucket: the reach, or more if there would be too many buckets.
float bucket_width_px(Vec2 extent_px, float reach_px) {
  return std::max(reach_px, std::sqrt(extent_px.x / kMostBuckets * extent_px.y));
}

/// Samples sorted into square buckets at least as wide as the reach, so that a query tests nine of them. In each bucket
/// they are in the order of the pieces, so that a query skips its own piece at once.
class SampleGrid {
 public:
  /// `samples`: at least one, in the order of the pieces.
  SampleGrid(const std::vector<BoundarySample>& samples, float reach_px) : reach_px_(reach_px) {
    low_px_ = samples.front().position_px;
    Vec2 high_px = low_px_;
    for (const BoundarySample& s : samples) {
      low_px_ = {std::min(low_px_.x, s.position_px.x), std::min(low_px_.y, s.position_px.y)};
      high_px = {std::max(high_px.x, s.position_px.x), std::max(high_px.y, s.position_px.y)};
    }
    const Vec2 extent_px = high_px - low_px_;
    bucket_px_ = bucket_width_px(extent_px, reach_px);
    first_ = {int(extent_px.x / bucket_px_) + 1, int(extent_px.y / bucket_px_) + 1};
    std::vector<std::uint32_t> size(first_.data().size() + 1, 0);
    for (const BoundarySample& s : samples) ++size[bucket_of(s.position_px)];
    std::uint32_t begin = 0;
    for (std::size_t i = 0; i < first_.data().size(); ++i) {
      first_.data()[i] = begin;
      begin += size[i];
    }
    sorted_.resize(samples.size());
    std::vector<std::uint32_t> next = first_.data();
    for (const BoundarySample& s : samples) sorted_[next[bucket_of(s.position_px)]++] = s;
  }

  bool another_piece_near(const BoundarySample& s) const {
    const int cx = column_of(s.position_px);
    const int cy = row_of(s.position_px);
    // Mostly the sample's own bucket gives the answer.
    if (bucket_has_another_near(std::size_t(cy) * first_.width() + cx, s)) return true;
    for (int y = std::max(0, cy - 1); y <= std::min(first_.height() - 1, cy + 1); ++y) {
      for (int x = std::max(0, cx - 1); x <= std::min(first_.width() - 1, cx + 1); ++x) {
        if (bucket_has_another_near(std::size_t(y) * first_.width() + x, s)) return true;
      }
    }
    return false;
  }

 private:
  int column_of(Vec2 p) const { return std::min(int((p.x - low_px_.x) / bucket_px_), first_.width() - 1); }
  int row_of(Vec2 p) const { return std::min(int((p.y - low_px_.y) / bucket_px_), first_.height() - 1); }
  std::size_t bucket_of(Vec2 p) const { return std::size_t(row_of(p)) * first_.width() + column_of(p); }

  bool bucket_has_another_near(std::size_t bucket, const BoundarySample& s) const {
    const auto begin = sorted_.begin() + first_.data()[bucket];
    const auto end = bucket + 1 < first_.data().size() ? sorted_.begin() + first_.data()[bucket + 1] : sorted_.end();
    const auto near = [&](const BoundarySample& other) {
      const Vec2 d = other.position_px - s.position_px;
      return dot(d, d) <= reach_px_ * reach_px_;
    };
    const auto [own, behind] = std::equal_range(begin, end, s, of_earlier_piece);
    return std::any_of(begin, own, near) || std::any_of(behind, end, near);
  }

  float reach_px_;
  float bucket_px_ = 0;
  Vec2 low_px_;                // of the first bucket
  Grid<std::uint32_t> first_;  // first index of a bucket's samples in sorted_
  std::vector<BoundarySample> sorted_;
};

}  // namespace

double shared_boundary_fraction(const Canvas& canvas, const std::vector<JudgedPiece>& pieces, float reach_px) {
  std::vector<BoundarySample> samples = sample_boundaries(pieces);
  if (samples.empty()) return 0;
  const std::size_t count = samples.size();
  cross_seams(canvas, reach_px, samples);
  const SampleGrid grid(samples, reach_px);
  const FieldView edge(canvas.distance);
  const auto shared = [&](const BoundarySample& s) {
    return !s.image && (std::abs(field_value(edge, s.position_px)) <= reach_px || grid.another_piece_near(s));
  };
  return double(std::count_if(samples.begin(), samples.end(), shared)) / double(count);
}

}  // namespace tessera
