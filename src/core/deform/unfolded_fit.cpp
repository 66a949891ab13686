#include "core/deform/unfolded_fit.h"

#include <algorithm>

namespace tessera {
namespace {

// The grid of a warp: fine enough for visible detail of a boundary, and bounded for large pieces.
constexpr float kStep_px = 3;
constexpr float kLeastStep = 1.f / 48;  // shape units
constexpr float kMostStep = 1.f / 10;

constexpr float kStiffer = 4;
constexpr int kMostStiffer = 5;  // up to a thousand times as stiff: nearly a translation of the whole

}  // namespace

UnfoldedFit::UnfoldedFit(const Shape& shape, float scale_px, float stiffness_px)
    : shape_(shape),
      scale_px_(scale_px),
      stiffness_px_(stiffness_px) {
  lay();
}

void UnfoldedFit::lay() {
  float stiffness_px = stiffness_px_;
  for (int k = 0; k < stiffer_; ++k) stiffness_px *= kStiffer;
  const float step = std::clamp(kStep_px / scale_px_, kLeastStep, kMostStep);
  fit_ = std::make_unique<WarpFit>(shape_, WarpFitSettings{step, stiffness_px / scale_px_});
}

Warp UnfoldedFit::warp(const std::vector<Vec2>& displacements) {
  Warp warp = fit_->fitted(displacements);
  for (; warp.least_jacobian() < kLeastJacobian && stiffer_ < kMostStiffer; warp = fit_->fitted(displacements)) {
    ++stiffer_;
    lay();
  }
  while (warp.least_jacobian() < kLeastJacobian) {  // this ends: without displacements there are no folds
    for (Vec2& d : warp.displacement.data()) d = d * 0.5f;
  }
  return warp;
}

}  // namespace tessera
