// Collage: its state out and in.
#include <algorithm>
#include <cmath>

#include "core/digest.h"
#include "core/error.h"
#include "master/collage.h"

namespace tessera::master {
namespace {

constexpr float kMostScale = 2;      // of the largest allowed; pieces grow past it a little
constexpr float kFarAway_px = 1e6f;  // beyond any canvas

[[noreturn]] void fail(const CheckpointState& state, const std::string& what) {
  throw InputError(state.name + ": not a checkpoint of this canvas and library: " + what);
}

bool sane(const Similarity& pose, float most_scale_px) {
  const auto near = [](float at_px) { return std::abs(at_px) < kFarAway_px; };  // not NaN either
  return near(pose.tx) && near(pose.ty) && pose.scale() > 0 && pose.scale() <= most_scale_px;
}

bool sane(const Window& window) {
  const auto near = [](int at) { return std::abs(std::int64_t(at)) < std::int64_t(kFarAway_px); };
  return near(window.x0) && near(window.y0) && near(window.x1) && near(window.y1);
}

}  // namespace

void Collage::save(CheckpointState& state) const {
  state.placements = placements_;
  for (const auto& [edge, entry] : pool_.entries()) state.pool.push_back({edge, entry.truncated, entry.candidates});
  std::sort(state.pool.begin(), state.pool.end(),
            [](const PooledSample& a, const PooledSample& b) { return a.edge < b.edge; });
  state.stale.assign(stale_.begin(), stale_.end());
  for (const auto& [edge, passes] : passes_) state.passes.push_back({edge, passes});
  state.matched = curve_.matched_pads();
  state.rebuilt_digest = rebuilt_digest();
}

void Collage::restore(const CheckpointState& state) {
  check_pieces(state);
  replace_placements(state.placements);
  check_samples(state);
  if (rebuilt_digest() != state.rebuilt_digest) {
    fail(state, "its pieces do not give the free region that it was written for");
  }
  for (const PooledSample& sample : state.pool) pool_.put_back(sample.edge, sample.candidates, sample.truncated);
  stale_ = {state.stale.begin(), state.stale.end()};
  for (const SamplePasses& sample : state.passes) passes_[sample.edge] = sample.passes;
  curve_.set_matched_pads(state.matched);
  changed_nodes_ = free_.field().value.bounds();
}

void Collage::check_pieces(const CheckpointState& state) const {
  const float most_scale_px = kMostScale * settings_.pieces.max_scale_px;
  const auto check = [&](std::uint32_t shape, const Similarity& pose) {
    if (shape >= poses_.size()) fail(state, "shape " + std::to_string(shape) + " of " + std::to_string(poses_.size()));
    if (!sane(pose, most_scale_px)) fail(state, "a piece out of all proportion");
  };
  for (const Placement& p : state.placements) check(p.shape, p.canvas_from_shape);
  for (const PooledSample& sample : state.pool) {
    for (const Candidate& c : sample.candidates) {
      check(c.shape, c.canvas_from_shape);
      if (!sane(c.window)) fail(state, "a candidate out of all proportion");
    }
  }
}

void Collage::check_samples(const CheckpointState& state) const {
  const auto check = [&](std::uint32_t edge) {
    if (!curve_.has_sample(edge)) fail(state, "there is no target sample " + std::to_string(edge));
  };
  for (const PooledSample& sample : state.pool) check(sample.edge);
  for (const std::uint32_t edge : state.stale) check(edge);
  for (const MatchedPad& pad : state.matched) check(pad.edge);
}

std::uint64_t Collage::rebuilt_digest() const {
  Digest digest;
  digest.add_all(std::span<const float>(free_.field().value.data()));
  for (const std::uint32_t edge : curve_.sample_edges()) {
    const TargetSample& sample = curve_.sample(edge);
    digest.add(edge);
    digest.add_all(std::span<const Vec2>(&sample.position, 1));
    digest.add_all(std::span<const Vec2>(&sample.tangent, 1));
    digest.add_all(std::span<const ArclengthPyramid>(&sample.pyramid, 1));
  }
  return digest.value();
}

}  // namespace tessera::master
