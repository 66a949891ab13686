#include "core/recognition/pad_poses.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "core/base/rank_pool.h"
#include "core/recognition/point_fit.h"

namespace tessera {
namespace {

/// Largest distance of PADs, and the number of nearest PADs that are tried for each PAD of the query.
constexpr float kPadReach = 0.08f;
constexpr std::size_t kMostPairs = 100;
/// Factor by which the scales of successive widths overlap.
constexpr float kWidthSlack = 1.04f;
/// If the key points of a pair are farther apart, the PADs belong to different curves.
constexpr float kMostResidual = 0.3f;
/// Largest ratio of the scale by key points to the scale that the widths of the smoothing imply.
constexpr float kScaleSlack = 1.15f;

class PadPoses {
 public:
  PadPoses(const Query& query, const KnownShapes& shapes, const PossibleScales& possible)
      : query_(query),
        shapes_(shapes),
        possible_(possible) {}

  /// Looks up each pair of a width and a level in a task of its own. The poses come in the order of widths and levels.
  std::vector<PosedShape> poses() const {
    const std::size_t levels = shapes_.levels().size();
    std::vector<std::vector<PosedShape>> of_part(query_.widths().size() * levels);
    parallel_for(of_part.size(), [&](std::size_t part) {
      const QueryWidth& width = query_.widths()[part / levels];
      const std::size_t level = part % levels;
      const ScaleLimits scales = scales_of(width.sigma, shapes_.levels()[level].level);
      if (scales.most < possible_.limits().least || scales.least > possible_.limits().most) return;
      for (const PartialPyramid& pyramid : width.pyramids) look_up(pyramid, level, scales, of_part[part]);
    });
    std::vector<PosedShape> poses;
    for (const std::vector<PosedShape>& some : of_part) poses.insert(poses.end(), some.begin(), some.end());
    return poses;
  }

 private:
  static ScaleLimits scales_of(float sigma, int level) {
    const float scale = sigma / kSmoothingLevels[std::size_t(level)].sigma;
    const float half_step = std::sqrt(kWidthStep) * kWidthSlack;
    return {scale / half_step, scale * half_step};
  }

  void look_up(const PartialPyramid& of_query, std::size_t level, const ScaleLimits& scales,
               std::vector<PosedShape>& poses) const {
    PadTarget target = make_pad_target(of_query.pyramid, of_query.left_levels, of_query.right_levels);
    if (std::min(of_query.left_levels, of_query.right_levels) > kChordLevel) {
      const float length = scale_length(of_query.pyramid, shapes_.pad_levels());
      target.scales = scale_window(length / scales.most, length / scales.least);
    }
    const KnownShapes::Level& index = shapes_.levels()[level];
    const auto wanted = [&](std::uint32_t place) { return possible_.may_have(index.shape_of(place), scales); };
    for (const PadHit& hit : index.search.nearest(target, kPadReach, kMostPairs, wanted)) {
      add_pose(of_query, level, hit.place, scales, poses);
    }
  }

  void add_pose(const PartialPyramid& of_query, std::size_t level, std::uint32_t place, const ScaleLimits& scales,
                std::vector<PosedShape>& poses) const {
    const auto first = std::size_t(shapes_.pad_levels() - of_query.left_levels);
    const auto count = std::size_t(of_query.left_levels + of_query.right_levels + 1);
    const Keypoints of_shape = shapes_.keypoints_of(level, place);
    const PointFit fit = fit_points(std::span(of_shape).subspan(first, count),
                                    std::span(of_query.pyramid.keypoint).subspan(first, count));
    if (fit.residual > kMostResidual) return;
    const float scale = fit.query_from_shape.scale();
    if (scale < scales.least / kScaleSlack || scale > scales.most * kScaleSlack) return;
    const std::uint32_t shape = shapes_.levels()[level].shape_of(place);
    if (!possible_.may_have(shape, {scale, scale})) return;
    poses.push_back({shape, fit.query_from_shape, 0});
  }

  const Query& query_;
  const KnownShapes& shapes_;
  const PossibleScales& possible_;
};

}  // namespace

std::vector<PosedShape> pad_poses(const Query& query, const KnownShapes& shapes, const PossibleScales& scales) {
  return PadPoses(query, shapes, scales).poses();
}

}  // namespace tessera
