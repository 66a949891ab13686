// Collage: its state out and in.
#include <algorithm>
#include <cmath>

#include "core/base/digest.h"
#include "core/base/error.h"
#include "master/collage.h"

namespace tessera::master {
namespace {

constexpr float kScaleSlack = 2;     // pieces leave the allowed scales by a rounding at most
constexpr float kFarAway_px = 1e6f;  // beyond any canvas
constexpr float kLongestContour = 1e4f;
constexpr float kLeastScale_px = 1e-3f;  // no job allows less; below, squares vanish
constexpr double kMostCovered = 4;       // times the canvas

[[noreturn]] void fail(const CheckpointState& state, const std::string& what) {
  throw InputError(state.name + ": not a checkpoint of this canvas and library: " + what +
                   "; --restart removes it and starts again");
}

/// A piece that was given may be of any size, locked or not.
bool sane(const Similarity& pose) {
  const auto near = [](float at_px) { return std::abs(at_px) < kFarAway_px; };  // not NaN either
  return near(pose.tx) && near(pose.ty) && near(pose.scale()) && pose.scale() > kLeastScale_px;
}

bool sane(const Similarity& pose, const PieceSettings& pieces) {
  return sane(pose) && pose.scale() * kScaleSlack >= pieces.min_scale_px &&
         pose.scale() <= kScaleSlack * pieces.max_scale_px;
}

/// Of a shape of area 1: no disc has less of either.
bool sane(float perimeter, float radius) {
  return perimeter >= 3.4f && perimeter <= kLongestContour && radius >= 0.55f && radius <= kLongestContour;
}

/// No larger than the canvas and as much again on each side: the pool looks at all tiles of the largest window.
bool sane(const Window& window, const Window& canvas) {
  const Window most = canvas.grown(std::max(canvas.width(), canvas.height()));
  return window.intersected(most) == window && !window.empty();
}

}  // namespace

void Collage::save(CheckpointState& state) const {
  state.region = limits_.region;
  state.given = std::uint32_t(given_);
  state.placements = placements_;
  for (const auto& [id, entry] : pool_.entries()) state.pool.push_back({id, entry.truncated, entry.candidates});
  std::sort(state.pool.begin(), state.pool.end(),
            [](const PooledSample& a, const PooledSample& b) { return a.id < b.id; });
  state.stale.assign(stale_.begin(), stale_.end());
  for (const auto& [id, passes] : passes_) state.passes.push_back({id, passes});
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
  for (const PooledSample& sample : state.pool) pool_.put_back(sample.id, sample.candidates, sample.truncated);
  stale_ = {state.stale.begin(), state.stale.end()};
  for (const SamplePasses& sample : state.passes) passes_[sample.id] = sample.passes;
  curve_.set_matched_pads(state.matched);
  changed_nodes_ = free_.field().value.bounds();
}

void Collage::check_pieces(const CheckpointState& state) const {
  const auto check = [&](ShapeId shape, const Similarity& pose, bool is_given) {
    if (index_of(shape) >= context_.library_shapes) {
      fail(state, "shape " + std::to_string(index_of(shape)) + " of " + std::to_string(context_.library_shapes));
    }
    if (!(is_given ? sane(pose) : sane(pose, settings_.pieces))) fail(state, "a piece out of all proportion");
  };
  const Wishes& wishes = settings_.wishes;
  const std::size_t any_size = wishes.given.size() > wishes.locked() ? state.placements.size() : given_;
  for (std::size_t i = 0; i < state.placements.size(); ++i) {
    check(state.placements[i].shape, state.placements[i].canvas_from_shape, i < any_size);
  }
  check_moving(state, check);
  check_best(state);
  for (const PooledSample& sample : state.pool) {
    for (const Candidate& c : sample.candidates) {
      check(c.shape, c.canvas_from_shape, false);
      if (c.stance >= context_.stances.stances().size()) fail(state, "a way of standing that the job does not know");
      if (!sane(c.window, free_.field().value.bounds()) || !sane(c.perimeter, c.radius)) {
        fail(state, "a candidate out of all proportion");
      }
    }
  }
}

/// Those that job or region gave are the first, and where they are; the others cover the canvas about once.
void Collage::check_moving(const CheckpointState& state, const CheckPiece& check) const {
  const std::vector<Placement>& moving = state.moving;
  if (moving.empty()) return;
  const bool any_size = settings_.wishes.given.size() > settings_.wishes.locked();
  const auto given = std::ptrdiff_t(given_);
  if (!state.improving || moving.size() < given_ ||
      !std::equal(moving.begin(), moving.begin() + given, state.placements.begin())) {
    fail(state, "pieces move that may not");
  }
  for (std::size_t i = 0; i < moving.size(); ++i) {
    check(moving[i].shape, moving[i].canvas_from_shape, i < given_ || any_size);
  }
  check_cover(state, moving, "more pieces move than have room");
}

/// Of an attempt at other sizes: the pieces that are given are the first there, too.
void Collage::check_best(const CheckpointState& state) const {
  const std::vector<Placement>& best = state.best.placements;
  for (const Placement& p : best) {
    if (index_of(p.shape) >= context_.library_shapes || !sane(p.canvas_from_shape)) {
      fail(state, "a piece of an attempt out of all proportion");
    }
  }
  if (!best.empty()) check_cover(state, best, "more pieces of an attempt than have room");
}

/// Without those that are given.
void Collage::check_cover(const CheckpointState& state, const std::vector<Placement>& pieces, const char* what) const {
  double area_px2 = 0;
  for (std::size_t i = given_; i < pieces.size(); ++i) {
    const double scale_px = pieces[i].canvas_from_shape.scale();
    area_px2 += scale_px * scale_px;
  }
  const Window& nodes = free_.grid().one_period();
  if (area_px2 > kMostCovered * nodes.width() * nodes.height()) fail(state, what);
}

void Collage::check_samples(const CheckpointState& state) const {
  const auto check = [&](SampleId id) {
    if (!curve_.has_sample(id)) fail(state, "there is no target sample " + std::to_string(edge_number(id)));
  };
  for (const PooledSample& sample : state.pool) check(sample.id);
  for (const SampleId id : state.stale) check(id);
  for (const MatchedPad& pad : state.matched) check(pad.sample);
}

std::uint64_t Collage::rebuilt_digest() const {
  Digest digest;
  digest.add_all(std::span<const float>(free_.field().value.data()));
  for (const SampleId id : curve_.samples()) {
    const TargetSample& sample = curve_.sample(id);
    digest.add(edge_number(id));
    digest.add_all(std::span<const Vec2>(&sample.position, 1));
    digest.add_all(std::span<const Vec2>(&sample.tangent, 1));
    digest.add_all(std::span<const ArclengthPyramid>(&sample.pyramid, 1));
  }
  return digest.value();
}

}  // namespace tessera::master
