#include "core/replacing/scene.h"

#include "core/relax/contacts.h"

namespace tessera {
namespace {

/// Stiffness of contacts at the end: then pieces lie as deep in each other as in a relaxed collage.
constexpr float kStiffness = 8;
constexpr float kSoftest = 0.2f * kStiffness;
constexpr float kSoft = 0.35f * kStiffness;
/// Additional stiffness beyond the depth that the job allows. Without it trials would win area here that is lost when
/// the collage is cleared.
constexpr float kHardStiffness = 20;
constexpr float kFirstStep = 0.035f;  // of the middle size
constexpr float kSoftStep_px = 1.5f;
constexpr float kLastStep_px = 0.3f;
constexpr RelaxationSchedule kSettleScene{20, kSoft, kStiffness, kSoftStep_px, kLastStep_px, kHardStiffness};
/// Cost of area covered twice: it is not gained, and it is hidden.
constexpr double kCoveredTwice = 2;

std::vector<ContactPiece> laid(const Scene& scene) {
  std::vector<ContactPiece> all(scene.pieces.size());
  for (std::size_t i = 0; i < all.size(); ++i) all[i].lay(*scene.pieces[i].shape, scene.pieces[i].canvas_from_shape);
  return all;
}

/// The area of `piece` inside `other`, by the points of its interior.
double within_px2(const ContactPiece& piece, const HoleShape& shape, const ContactPiece& other) {
  std::size_t points = 0;
  for (const Vec2 p : shape.interior) {
    const Vec2 at = piece.canvas_from_shape.apply(p);
    points += within_reach(other.box, {at, at}, 0) && other.distance(at).value < 0;
  }
  const double area_px2 = double(piece.scale_px) * double(piece.scale_px);
  return points > 0 ? area_px2 * double(points) / double(shape.interior.size()) : 0;
}

/// Boundary samples do not see a piece that lies wholly within another, or exactly on a copy of its shape. So this
/// adds, for each pair that a trial may change, the area of one in the other, both ways.
double covered_twice_px2(const Scene& scene) {
  const std::vector<ContactPiece> all = laid(scene);
  std::vector<bool> active(all.size(), false);
  for (const std::size_t i : scene.active) active[i] = true;
  double covered_px2 = 0;
  for (const std::size_t i : scene.active) {
    for (std::size_t j = 0; j < all.size(); ++j) {
      if (j == i || !within_reach(all[i].box, all[j].box, 0)) continue;
      covered_px2 += within_px2(all[i], *scene.shapes[i], all[j]);
      // otherwise j's own turn does this
      if (!active[j]) covered_px2 += within_px2(all[j], *scene.shapes[j], all[i]);
    }
  }
  return covered_px2;
}

}  // namespace

void Scene::add(const HoleShape& shape, const Similarity& canvas_from_shape, const PoseRange& poses, bool moves) {
  if (moves) active.push_back(pieces.size());
  pieces.push_back({&shape.contact, canvas_from_shape, poses, !moves});
  shapes.push_back(&shape);
}

SceneRelaxation::SceneRelaxation(const ReplacementWindow& window)
    : edge_(window.edge.distance, window.edge.node_px),
      relaxation_(edge_, window.distances),
      first_step_px_(kFirstStep * middle_px(window)) {}

void SceneRelaxation::relax_softly(Scene& scene) const {
  relaxation_.relax(scene.pieces, scene.active, {10, kSoftest, kSoft, first_step_px_, kSoftStep_px}, [] {});
}

void SceneRelaxation::relax_fully(Scene& scene) const {
  relaxation_.relax(scene.pieces, scene.active, kSettleScene, [] {});
}

double SceneRelaxation::energy_px2(const Scene& scene) const {
  return relaxation_.energy_px2(scene.pieces, scene.active, kStiffness, kHardStiffness) +
         kCoveredTwice * covered_twice_px2(scene);
}

}  // namespace tessera
