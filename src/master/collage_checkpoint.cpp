// Saves and restores the state of a Collage.
#include <algorithm>
#include <cmath>

#include "core/base/digest.h"
#include "core/base/error.h"
#include "master/collage.h"

namespace tessera::master {
namespace {

constexpr float kScaleSlack = 2;     // rounding may take pieces out of the allowed scales by far less
constexpr float kFarAway_px = 1e6f;  // beyond any canvas
constexpr float kLongestContour = 1e4f;
constexpr float kLeastScale_px = 1e-3f;  // no job allows less; below, squares vanish
constexpr double kMostCovered = 4;       // times the canvas

[[noreturn]] void fail(const CheckpointState& state, const std::string& what) {
  throw InputError(state.name + ": not a checkpoint of this canvas and library: " + what +
                   "; --restart removes it and starts again");
}

/// Whether a pose is possible at all. A given piece may have any size, locked or not.
bool sane(const Similarity& pose) {
  const auto near = [](float at_px) { return std::abs(at_px) < kFarAway_px; };  // not NaN either
  return near(pose.tx) && near(pose.ty) && near(pose.scale()) && pose.scale() > kLeastScale_px;
}

bool sane(const Similarity& pose, const PieceSettings& pieces) {
  return sane(pose) && pose.scale() * kScaleSlack >= pieces.min_scale_px &&
         pose.scale() <= kScaleSlack * pieces.max_scale_px;
}

/// Whether perimeter and radius are possible for a shape of area 1: no shape has less of either than a disc.
bool sane(float perimeter, float radius) {
  return perimeter >= 3.4f && perimeter <= kLongestContour && radius >= 0.55f && radius <= kLongestContour;
}

/// Whether the window reaches at most one canvas size beyond the canvas. The pool looks at all tiles of the largest window.
bool sane(const Window& window, const Window& canvas) {
  const Window most = canvas.grown(std::max(canvas.width(), canvas.height()));
  return window.intersected(most) == window && !window.empty();
}

/// Refuses a state whose parts cannot belong to the canvas and the library.
class StateChecks {
 public:
  /// All arguments outlive the checks.
  StateChecks(const CheckpointState& state, const CollageSettings& settings, const OpenShapes& open_shapes,
              const FreeField& free)
      : state_(state),
        settings_(settings),
        open_shapes_(open_shapes),
        free_(free),
        frees_given_pieces_(settings.wishes.given.size() > settings.wishes.locked()) {}

  void check_pieces() const {
    const std::size_t any_size = frees_given_pieces_ ? state_.placements.size() : open_shapes_.given();
    for (std::size_t i = 0; i < state_.placements.size(); ++i) {
      check_piece(state_.placements[i].shape, state_.placements[i].canvas_from_shape, i < any_size);
    }
    check_moving();
    check_best();
    check_batch();
    for (const PooledSample& sample : state_.pool) {
      for (const Candidate& c : sample.candidates) check_candidate(c);
    }
  }

  void check_samples(const TargetCurve& curve) const {
    const auto check = [&](SampleId id) {
      if (!curve.has_sample(id)) fail(state_, "there is no target sample " + std::to_string(edge_number(id)));
    };
    for (const PooledSample& sample : state_.pool) check(sample.id);
    for (const SampleId id : state_.stale) check(id);
    for (const MatchedPad& pad : state_.matched) check(pad.sample);
  }

 private:
  void check_piece(ShapeId shape, const Similarity& pose, bool any_size) const {
    const std::uint32_t shapes = open_shapes_.context().library_shapes;
    if (index_of(shape) >= shapes) {
      fail(state_, "shape " + std::to_string(index_of(shape)) + " of " + std::to_string(shapes));
    }
    if (!(any_size ? sane(pose) : sane(pose, settings_.pieces)))
      fail(state_, "a piece with an impossible size or place");
  }

  void check_candidate(const Candidate& c) const {
    check_piece(c.shape, c.canvas_from_shape, false);
    if (c.stance >= open_shapes_.stances().stances().size()) fail(state_, "a stance that the job does not have");
    if (!sane(c.window, free_.field().value.bounds()) || !sane(c.perimeter, c.radius)) {
      fail(state_, "a candidate with an impossible size or place");
    }
  }

  /// Checks that the pieces of the batch were placed here.
  void check_batch() const {
    if (state_.batch_pieces <= state_.placements.size() - open_shapes_.given()) return;
    fail(state_, "more pieces in a batch than were placed");
  }

  /// Checks the pieces of a replacement phase: the given ones come first and have not moved, the others cover the canvas
  /// about once.
  void check_moving() const {
    const std::vector<Placement>& moving = state_.loop.moving;
    if (moving.empty()) return;
    const std::size_t given = open_shapes_.given();
    if (state_.loop.phase != LoopPhase::replacing || moving.size() < given ||
        !std::equal(moving.begin(), moving.begin() + std::ptrdiff_t(given), state_.placements.begin())) {
      fail(state_, "its replacement phase moves pieces that must stay");
    }
    for (std::size_t i = 0; i < moving.size(); ++i) {
      check_piece(moving[i].shape, moving[i].canvas_from_shape, i < given || frees_given_pieces_);
    }
    check_cover(moving, "its replacement phase has far more pieces than fit");
  }

  /// Checks the pieces of the best attempt at sizes; the given pieces come first there, too.
  void check_best() const {
    const std::vector<Placement>& best = state_.best.placements;
    for (const Placement& p : best) {
      if (index_of(p.shape) >= open_shapes_.context().library_shapes || !sane(p.canvas_from_shape)) {
        fail(state_, "a piece of its best attempt with an impossible size or place");
      }
    }
    if (!best.empty()) check_cover(best, "its best attempt has far more pieces than fit");
  }

  /// Checks that the pieces, without the given ones, do not cover far more than the canvas.
  void check_cover(const std::vector<Placement>& pieces, const char* what) const {
    double area_px2 = 0;
    for (std::size_t i = open_shapes_.given(); i < pieces.size(); ++i) {
      const double scale_px = pieces[i].canvas_from_shape.scale();
      area_px2 += scale_px * scale_px;
    }
    const Window& nodes = free_.grid().one_period();
    if (area_px2 > kMostCovered * nodes.width() * nodes.height()) fail(state_, what);
  }

  const CheckpointState& state_;
  const CollageSettings& settings_;
  const OpenShapes& open_shapes_;
  const FreeField& free_;
  bool frees_given_pieces_;  // improving may have moved some of them
};

}  // namespace

void Collage::save(CheckpointState& state) const {
  state.given = std::uint32_t(open_shapes_.given());
  state.placements = placements_;
  for (const auto& [id, entry] : pool_.entries()) state.pool.push_back({id, entry.truncated, entry.candidates});
  std::sort(state.pool.begin(), state.pool.end(),
            [](const PooledSample& a, const PooledSample& b) { return a.id < b.id; });
  schedule_.save(state);
  state.batch_pieces = std::uint32_t(batch_.pieces());
  if (batch_.is_open()) {
    state.batch_worth = batch_.first_worth();
    state.batch_taken = batch_.taken();
  }
  state.matched = curve_.matched_pads();
  state.rebuilt_digest = rebuilt_digest();
}

/// Target curve, pool and schedule are those before the open batch.
void Collage::restore(const CheckpointState& state) {
  const StateChecks checks(state, settings_, open_shapes_, free_);
  checks.check_pieces();
  const auto first_of_batch = state.placements.end() - std::ptrdiff_t(state.batch_pieces);
  replace_placements({state.placements.begin(), first_of_batch});
  checks.check_samples(curve_);
  for (auto piece = first_of_batch; piece != state.placements.end(); ++piece) {
    placements_.push_back(*piece);
    add_to_batch(*piece, state.batch_worth);
  }
  if (batch_.is_open() && !batch_.set_taken(state.batch_taken)) fail(state, "a batch on another canvas");
  if (rebuilt_digest() != state.rebuilt_digest) {
    fail(state, "its pieces leave another free region than the saved one");
  }
  for (const PooledSample& sample : state.pool) pool_.put_back(sample.id, sample.candidates, sample.truncated);
  schedule_.restore(state);
  curve_.set_matched_pads(state.matched);
  if (scoring_.limits_uses()) update_open_shapes();
  changed_nodes_ = {free_.field().value.bounds()};
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
