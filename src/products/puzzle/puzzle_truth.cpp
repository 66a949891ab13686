#include "products/puzzle/puzzle_truth.h"

#include <algorithm>
#include <cmath>

#include "products/puzzle/pieces/puzzle_contact.h"

namespace tessera {
namespace {

/// The shift of a piece that is right; empty where it is not right.
std::optional<float> right_by(const Similarity& found, const Similarity& truth) {
  const float shift = norm(found.translation() - truth.translation());
  const float cosine = (found.a * truth.a + found.b * truth.b) / (found.scale() * truth.scale());
  const float sine = (found.b * truth.a - found.a * truth.b) / (found.scale() * truth.scale());
  const bool turned = cosine < 0 || std::abs(sine) > kRightTurn_rad;
  const bool scaled = std::abs(found.scale() / truth.scale() - 1) > kRightScale;
  if (shift > kRightShift_px || turned || scaled) return {};
  return shift;
}

}  // namespace

PuzzleAgreement agreement(const std::vector<std::optional<Similarity>>& found,
                          const std::vector<std::optional<Similarity>>& truth) {
  PuzzleAgreement best;
  for (std::size_t i = 0; i < found.size(); ++i) {
    if (!found[i] || !truth[i]) continue;
    const Similarity truth_from_found = followed_by(found[i]->inverse(), *truth[i]);
    PuzzleAgreement here;
    for (std::size_t j = 0; j < found.size(); ++j) {
      if (!found[j] || !truth[j]) continue;
      const Similarity there = followed_by(*found[j], truth_from_found);
      ++here.laid;
      here.farthest_px = std::max(here.farthest_px, norm(there.translation() - truth[j]->translation()));
      const std::optional<float> shift = right_by(there, *truth[j]);
      if (!shift) continue;
      ++here.right;
      here.worst_px = std::max(here.worst_px, *shift);
    }
    if (here.right > best.right || (here.right == best.right && here.worst_px < best.worst_px)) best = here;
  }
  return best;
}

}  // namespace tessera
