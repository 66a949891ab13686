#include "core/recognition/curve_match.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "core/recognition/boundary_fit.h"
#include "core/recognition/curve_points.h"
#include "core/recognition/curve_poses.h"

namespace tessera {
namespace {

/// Number of poses that are sorted by the fast estimate, and number that are refined.
constexpr std::size_t kMostSorted = 4000;
constexpr std::size_t kMostRefinedPoses = 300;
/// Reach of the refinement: first in parts of A's radius, then in widths of A's narrowest smoothing.
constexpr int kCoarseSteps = 6;
constexpr float kCoarseReach = 0.15f;
constexpr float kCoarseLeastReach = 0.03f;
constexpr int kFineSteps = 6;
constexpr float kFineReach = 1;
constexpr float kPoseScaleSlack = 1.4f;  // largest change of the scale, as a factor
/// Spacing of points, as a fraction of the radius.
constexpr float kPointSpacing = 1.f / 96;
/// Points are farther apart on curves that would have more than this: scribbles and noise.
constexpr float kMostMatchPoints = 4000;
constexpr float kRunReach = 0.03f;
constexpr float kRunWidths = 2;
constexpr float kLeastRun = 5;  // in reaches
constexpr float kCurveSmoothing = 2.f / 3;
/// A lower score is no match. A higher one does not prove kinship: unrelated silhouettes reach 0.2 to 0.4 by similar
/// parts.
constexpr float kLeastScore = 0.05f;

struct PosedCurves {
  Similarity a_from_b;
  float score = 0;
};

bool any_open(const std::vector<Curve>& curves) {
  return std::any_of(curves.begin(), curves.end(), [](const Curve& curve) { return !curve.closed; });
}

std::vector<Curve> reversed(std::vector<Curve> curves) {
  for (Curve& curve : curves) std::reverse(curve.points.begin(), curve.points.end());
  return curves;
}

std::vector<Curve> evenly(const MatchedCurves& of, const Query& query) {
  return even_curves(of.curves, kCurveSmoothing * of.least_sigma,
                     std::max(kPointSpacing * query.radius(), query.length() / kMostMatchPoints));
}

float total_length(const std::vector<Curve>& curves) {
  float length = 0;
  for (const Curve& curve : curves) length += length_of(curve);
  return length;
}

class CurveMatcher {
 public:
  CurveMatcher(const MatchedCurves& a, const MatchedCurves& b, const PadParameters& pad)
      : a_(a),
        b_(b),
        pad_(pad),
        any_direction_(any_open(a.curves) || any_open(b.curves)),
        query_a_(a.curves, {pad, a.least_sigma}),
        query_b_(b.curves, {pad, b.least_sigma}),
        even_a_(evenly(a, query_a_)),
        even_b_(evenly(b, query_b_)),
        points_(even_b_) {
    if (any_direction_) points_.add_opposite();
  }

  std::vector<CurveMatch> best(std::size_t most) const {
    std::vector<CurveMatch> matches;
    std::vector<Similarity> taken;
    for (const PosedCurves& posed : refined(sorted_poses())) {
      if (matches.size() == most) break;
      if (posed.score < kLeastScore || is_near_any_pose(taken, posed.a_from_b, query_a_)) continue;
      taken.push_back(posed.a_from_b);
      CurveMatch match = match_at(posed);
      if (!match.runs.empty()) matches.push_back(std::move(match));
    }
    return matches;
  }

 private:
  /// The fraction of A that is followed, converted to the geometric mean of both lengths.
  float score_of(float followed, const Similarity& a_from_b) const {
    return std::min(1.f, followed * std::sqrt(query_a_.length() / (query_b_.length() * a_from_b.scale())));
  }

  std::vector<Similarity> all_poses() const {
    std::vector<Similarity> poses;
    const auto add = [&](const std::vector<Similarity>& more) { poses.insert(poses.end(), more.begin(), more.end()); };
    add(curve_poses(query_a_, query_b_, pad_.levels));
    add(arc_pair_poses(query_a_, query_b_));
    if (!any_direction_) return poses;
    const Query other_way(reversed(b_.curves), {pad_, b_.least_sigma});
    add(curve_poses(query_a_, other_way, pad_.levels));
    add(arc_pair_poses(query_a_, other_way));
    add(straight_poses(a_.curves, b_.curves));
    return poses;
  }

  static void sort_and_cut(std::vector<PosedCurves>& posed, std::size_t most) {
    std::stable_sort(posed.begin(), posed.end(),
                     [](const PosedCurves& a, const PosedCurves& b) { return a.score > b.score; });
    if (posed.size() > most) posed.resize(most);
  }

  std::vector<PosedCurves> sorted_poses() const {
    std::vector<PosedCurves> posed;
    for (const Similarity& pose : all_poses()) {
      posed.push_back({pose, score_of(roughly_followed(query_a_, points_.boundary(), pose), pose)});
    }
    sort_and_cut(posed, kMostSorted);
    return posed;
  }

  /// The different poses, refined on A's curves, the best first.
  std::vector<PosedCurves> refined(const std::vector<PosedCurves>& starts) const {
    std::vector<PosedCurves> result;
    std::vector<Similarity> tried;
    for (const PosedCurves& start : starts) {
      if (tried.size() == kMostRefinedPoses) break;
      if (is_near_any_pose(tried, start.a_from_b, query_a_)) continue;
      tried.push_back(start.a_from_b);
      const Similarity pose = refined_pose_from(start.a_from_b);
      result.push_back({pose, score_of(followed_part(query_a_, points_.boundary(), pose), pose)});
    }
    sort_and_cut(result, kMostRefinedPoses);
    return result;
  }

  Similarity refined_pose_from(const Similarity& start) const {
    const ScaleLimits scales{start.scale() / kPoseScaleSlack, start.scale() * kPoseScaleSlack};
    const float fine = kFineReach * query_a_.least_sigma();
    const float near = std::max(fine, kCoarseLeastReach * query_a_.radius());
    const Similarity pose =
        refined_pose(query_a_, points_.boundary(), start, kCoarseSteps, kCoarseReach * query_a_.radius(), near, scales);
    const Similarity finer = refined_pose(query_a_, points_.boundary(), pose, kFineSteps, near, fine, scales);
    const auto followed = [&](const Similarity& p) {
      return score_of(followed_part(query_a_, points_.boundary(), p), p);
    };
    return followed(finer) > followed(pose) ? finer : pose;
  }

  CurveMatch match_at(const PosedCurves& posed) const {
    CurveMatch match;
    match.a_from_b = posed.a_from_b;
    match.score = posed.score;
    const float reach = std::max(kRunWidths * query_a_.least_sigma(), kRunReach * query_a_.radius());
    match.runs = matched_runs(even_a_, even_b_, posed.a_from_b, {reach, kLeastRun * reach, any_direction_});
    float of_b = 0;
    for (const MatchedRun& run : match.runs) of_b += run.of_b.length();
    match.part_of_a = std::min(1.f, covered_length_of_a(even_a_, match.runs) / total_length(even_a_));
    match.part_of_b = std::min(1.f, of_b / total_length(even_b_));
    match.similarity = closeness_of(match);
    for (MatchedRun& run : match.runs) {
      stretch(run.of_a, a_.curves, even_a_);
      stretch(run.of_b, b_.curves, even_b_);
    }
    return match;
  }

  /// The mean closeness over the points of B in the runs.
  float closeness_of(const CurveMatch& match) const {
    float sum = 0, points = 0;
    for (const MatchedRun& run : match.runs) {
      const std::vector<Vec2>& curve = even_b_[run.of_b.curve].points;
      const float step =
          length_of(even_b_[run.of_b.curve]) / float(curve.size() - (even_b_[run.of_b.curve].closed ? 0 : 1));
      const auto first = std::size_t(run.of_b.from / step + 0.5f);
      const auto count = std::size_t(run.of_b.length() / step + 0.5f);
      for (std::size_t k = first; k < first + count; ++k, ++points) {
        sum += closeness(query_a_, query_a_.map().nearest(match.a_from_b.apply(curve[k % curve.size()])).distance);
      }
    }
    return points > 0 ? sum / points : 0;
  }

  /// Converts arclengths of a smoothed curve to those of the given one, which is a little longer.
  static void stretch(CurvePart& part, const std::vector<Curve>& given, const std::vector<Curve>& even) {
    const float factor = length_of(given[part.curve]) / length_of(even[part.curve]);
    part.from *= factor;
    part.to *= factor;
  }

  const MatchedCurves& a_;
  const MatchedCurves& b_;
  PadParameters pad_;
  bool any_direction_;
  Query query_a_;
  Query query_b_;
  std::vector<Curve> even_a_;
  std::vector<Curve> even_b_;
  CurvePoints points_;
};

}  // namespace

std::vector<CurveMatch> matched_curves(const MatchedCurves& a, const MatchedCurves& b, std::size_t most,
                                       const PadParameters& pad) {
  return CurveMatcher(a, b, pad).best(most);
}

}  // namespace tessera
