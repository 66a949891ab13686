#include "core/recognition/matched_runs.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/geometry/polygon.h"
#include "core/recognition/curve_map.h"

namespace tessera {
namespace {

constexpr float kLeastRunCosine = 0.8f;
/// Size of the map's cells: a fraction of the reach, but at least a fraction of the curves' bounding box, so that a
/// distant speck does not cost gigabytes.
constexpr float kCellOfReach = 0.5f;
constexpr float kCellOfBox = 1.f / 1024;
/// Largest distance along A between two neighbours of B, in parts of the reach.
constexpr float kLargestStep = 3;
/// Reach beyond the end of an open curve, where the curve is not followed any more; in parts of the reach.
constexpr float kEndReach = 0.25f;

/// The place of a point of B along a curve of A; `curve` is kNone if the point follows none.
struct Followed {
  static constexpr std::size_t kNone = ~std::size_t(0);
  std::size_t curve = kNone;
  float along = 0;  // on that curve
  bool reversed = false;
};

CurveMap map_of(const std::vector<Curve>& curves, float reach) {
  Box box = bounding_box(curves.front().points);
  float cell = kCellOfReach * reach;
  for (const Curve& curve : curves) {
    box = united(box, bounding_box(curve.points));
    cell = std::max(cell, length_of(curve) / float(curve.points.size() - 1));
  }
  cell = std::max(cell, kCellOfBox * std::max(box.width(), box.height()));
  return CurveMap(curves, cell, std::max(reach, 2 * cell));
}

class RunFinder {
 public:
  RunFinder(const std::vector<Curve>& a, const Similarity& a_from_b, const RunSettings& settings)
      : a_from_b_(a_from_b),
        settings_(settings),
        map_(map_of(a, settings.reach)) {
    for (const Curve& curve : a) {
      starts_.push_back(starts_.empty() ? 0 : starts_.back() + lengths_.back());
      lengths_.push_back(length_of(curve));
      closed_.push_back(curve.closed);
    }
  }

  void add_runs(const Curve& curve, std::size_t number, std::vector<MatchedRun>& runs) {
    const std::vector<Followed> followed = followed_by(curve);
    const std::size_t count = followed.size();
    const float length = length_of(curve);
    const float step = length / float(curve.closed ? count : count - 1);
    // A closed curve is walked from a point at which a run cannot continue, if there is one.
    std::size_t start = 0;
    if (curve.closed) {
      while (start < count && goes_on(followed[(start + count - 1) % count], followed[start])) ++start;
      if (start == count) start = 0;
    }
    for (std::size_t k = 0; k < count;) {
      std::size_t end = k + 1;
      while (end < count && goes_on(followed[(start + end - 1) % count], followed[(start + end) % count])) ++end;
      if (followed[(start + k) % count].curve != Followed::kNone) {
        const bool whole = curve.closed && end - k == count;
        MatchedRun run = run_of(followed, start + k, start + end);
        const float from = float((start + k) % count) * step;
        run.of_b = {number, from, from + float(end - k - (whole ? 0 : 1)) * step};
        if (run.of_b.length() * a_from_b_.scale() >= settings_.least_length) runs.push_back(run);
      }
      k = end;
    }
  }

 private:
  std::vector<Followed> followed_by(const Curve& curve) const {
    const std::vector<Vec2> tangents = tangents_of(curve);
    std::vector<Followed> followed(curve.points.size());
    for (std::size_t i = 0; i < curve.points.size(); ++i) {
      const CurveMap::Nearest near = map_.nearest(a_from_b_.apply(curve.points[i]));
      if (near.distance > (near.at_end ? kEndReach : 1) * settings_.reach) continue;
      const float cosine = dot(a_from_b_.apply_direction(tangents[i]), near.tangent) / a_from_b_.scale();
      if ((settings_.any_direction ? std::abs(cosine) : cosine) < kLeastRunCosine) continue;
      const auto after = std::upper_bound(starts_.begin(), starts_.end(), near.along);
      const auto a = std::size_t(std::max<std::ptrdiff_t>(after - starts_.begin() - 1, 0));
      followed[i] = {a, near.along - starts_[a], cosine < 0};
    }
    return followed;
  }

  /// The step from one place on a curve of A to the next one, the short way round.
  float step_along(const Followed& from, const Followed& to) const {
    const float step = to.along - from.along;
    if (!closed_[to.curve]) return step;
    return step - lengths_[to.curve] * std::round(step / lengths_[to.curve]);
  }

  bool goes_on(const Followed& before, const Followed& here) const {
    if (before.curve == Followed::kNone || here.curve != before.curve || here.reversed != before.reversed) return false;
    return std::abs(step_along(before, here)) <= kLargestStep * settings_.reach;
  }

  /// Makes A's side of the run.
  MatchedRun run_of(const std::vector<Followed>& followed, std::size_t begin, std::size_t end) const {
    const Followed& first = followed[begin % followed.size()];
    float along = first.along, least = along, most = along;
    for (std::size_t k = begin + 1; k < end; ++k) {
      along += step_along(followed[(k - 1) % followed.size()], followed[k % followed.size()]);
      least = std::min(least, along);
      most = std::max(most, along);
    }
    const float length = lengths_[first.curve];
    const float rounds = closed_[first.curve] ? std::floor(least / length) * length : 0;
    MatchedRun run;
    run.of_a = {first.curve, least - rounds, std::min(most, least + length) - rounds};
    run.reversed = first.reversed;
    return run;
  }

  Similarity a_from_b_;
  RunSettings settings_;
  CurveMap map_;
  std::vector<float> starts_;  // starts of A's curves in the map's arclength
  std::vector<float> lengths_;
  std::vector<bool> closed_;
};

}  // namespace

std::vector<MatchedRun> matched_runs(const std::vector<Curve>& a, const std::vector<Curve>& b,
                                     const Similarity& a_from_b, const RunSettings& settings) {
  RunFinder finder(a, a_from_b, settings);
  std::vector<MatchedRun> runs;
  for (std::size_t k = 0; k < b.size(); ++k) finder.add_runs(b[k], k, runs);
  return runs;
}

std::vector<Vec2> points_of(const Curve& curve, const CurvePart& part) {
  const std::size_t count = curve.points.size();
  std::vector<Vec2> points;
  float along = 0;
  const std::size_t edges = curve.closed ? 2 * count : count - 1;
  for (std::size_t k = 0; k < edges && along <= part.to; ++k) {
    const Vec2 from = curve.points[k % count];
    const Vec2 edge = curve.points[(k + 1) % count] - from;
    const float length = norm(edge);
    if (length > 0 && along + length >= part.from) {
      if (points.empty()) points.push_back(from + edge * (std::max(0.f, part.from - along) / length));
      points.push_back(from + edge * (std::min(length, part.to - along) / length));
    }
    along += length;
  }
  return points;
}

float covered_length_of_a(const std::vector<Curve>& a, const std::vector<MatchedRun>& runs) {
  float covered = 0;
  for (std::size_t k = 0; k < a.size(); ++k) {
    const float length = length_of(a[k]);
    std::vector<std::pair<float, float>> parts;
    for (const MatchedRun& run : runs) {
      if (run.of_a.curve != k) continue;
      parts.push_back({run.of_a.from, std::min(run.of_a.to, length)});
      if (run.of_a.to > length) parts.push_back({0, run.of_a.to - length});
    }
    std::sort(parts.begin(), parts.end());
    float until = 0;
    for (const auto& [from, to] : parts) {
      covered += std::max(0.f, to - std::max(from, until));
      until = std::max(until, to);
    }
  }
  return covered;
}

}  // namespace tessera
