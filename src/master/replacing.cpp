#include "master/replacing.h"

#include <cmath>
#include <set>
#include <utility>

#include "core/base/stop.h"
#include "core/matching/use_limits.h"
#include "core/replacing/draws.h"
#include "core/replacing/incoming_shapes.h"
#include "core/replacing/repetition_costs.h"
#include "master/relaxing.h"
#include "master/rules/kept_apart.h"

namespace tessera::master {
namespace {

constexpr std::uint64_t kReplace = 0x7265706c;  // keeps these random numbers apart from others
constexpr float kTrialsPerPiece = 2;            // in one batch
constexpr float kFirstTemperature = 0.03f;      // times least scale times most scale, px²

/// The area that each drawing covers on the whole canvas.
std::map<ShapeId, double> covered_px2(const std::vector<PosedPiece>& all) {
  std::map<ShapeId, double> px2;
  for (const PosedPiece& posed : all) {
    const double scale_px = double(posed.piece.canvas_from_shape.scale());
    px2[posed.piece.drawing] += scale_px * scale_px;
  }
  return px2;
}

/// The drawings that move in the window or may come in, ascending, with the area that each covers on the whole canvas.
std::vector<DrawingArea> drawn_in(const ReplacementWindow& window, const std::map<ShapeId, double>& all_px2) {
  std::set<ShapeId> drawings;
  for (const IncomingShape& in : window.incoming) drawings.insert(in.drawing);
  for (const WindowPiece& piece : window.moving) drawings.insert(piece.drawing);
  std::vector<DrawingArea> drawn;
  for (const ShapeId drawing : drawings) {
    const auto found = all_px2.find(drawing);
    drawn.push_back({drawing, found == all_px2.end() ? 0 : found->second});
  }
  return drawn;
}

std::uint64_t count_trials(const std::vector<CutWindow>& cuts) {
  std::uint64_t trials = 0;
  for (const CutWindow& cut : cuts) trials += cut.window.trials;
  return trials;
}

}  // namespace

bool pays_to_replace(const CollageSettings& s) {
  return pays_to_relax(s) && !UseLimits(s.pieces, s.wishes).any() && !any_kept_apart(s) && s.colour.neighbours == 0 &&
         s.stop.pieces == 0 && !s.start.grow_outward;
}

Replacing::Replacing(const FreeField& free, const StanceTable& stances, const CollageSettings& settings,
                     double area_px2, ShapeSource& shapes, PosesOf poses_of, Replacer& replacer)
    : period_(free.grid().period()),
      windows_(free, settings.pieces, repetition_costs(settings, count_drawings(stances, shapes), area_px2)),
      stances_(stances),
      settings_(settings),
      shapes_(shapes),
      poses_of_(std::move(poses_of)),
      replacer_(replacer) {}

std::vector<Placement> Replacing::batch(const std::vector<Placement>& placements, std::size_t given,
                                        ReplacementProgress& progress, const StopCheck& check_stop) {
  const std::uint64_t key = mix_bits(settings_.seed ^ mix_bits(kReplace ^ (progress.done << 24)));
  const std::vector<PosedPiece> all = posed_pieces(placements, shapes_, poses_of_, check_stop);
  Draws draws(key);
  const float part_x = draws.unit();
  const float part_y = draws.unit();
  std::vector<CutWindow> cuts = windows_.cut(all, given, part_x, part_y, check_stop);
  for (std::size_t i = 0; i < cuts.size(); ++i) cuts[i].window.random = mix_bits(key ^ i);
  ReplacementProgress after = progress;
  plan(cuts, after);
  const std::vector<IncomingShape> incoming = incoming_shapes(stances_, shapes_, key);
  const std::vector<ReplacementOutcome> outcomes = run_windows(cuts, all, incoming, check_stop);
  progress = after;
  return joined(placements, cuts, outcomes);
}

/// Sets each window's number of trials and its temperatures. All windows together have no more trials than are left.
void Replacing::plan(std::vector<CutWindow>& cuts, ReplacementProgress& progress) const {
  for (CutWindow& c : cuts) c.window.trials = std::uint32_t(std::ceil(kTrialsPerPiece * float(c.moving.size())));
  const std::uint64_t left = progress.all - progress.done;
  const std::uint64_t wanted = count_trials(cuts);
  if (wanted > left) {
    for (CutWindow& c : cuts) c.window.trials = std::uint32_t(std::uint64_t(c.window.trials) * left / wanted);
  }
  const auto temperature_px2 = [&](std::uint64_t done) {
    const float hottest = kFirstTemperature * settings_.pieces.min_scale_px * settings_.pieces.max_scale_px;
    return hottest * float(1 - double(done) / double(progress.all));
  };
  const std::uint64_t done = progress.done + count_trials(cuts);
  for (CutWindow& c : cuts) {
    c.window.first_temperature_px2 = temperature_px2(progress.done);
    c.window.last_temperature_px2 = temperature_px2(done);
  }
  // A batch that has no trials to share out, or in which no piece may move, is the last one.
  progress.done = done > progress.done ? done : progress.all;
}

/// Asks for a few windows at a time for each core that works on them, so that no question is long or holds the memory of
/// all windows.
std::vector<ReplacementOutcome> Replacing::run_windows(std::vector<CutWindow>& cuts, const std::vector<PosedPiece>& all,
                                                       const std::vector<IncomingShape>& incoming,
                                                       const StopCheck& check_stop) {
  const std::map<ShapeId, double> all_px2 = covered_px2(all);
  const std::size_t most = kWindowsAtATime * std::size_t(replacer_.breadth());
  std::vector<ReplacementOutcome> outcomes;
  while (outcomes.size() < cuts.size()) {
    std::vector<ReplacementWindow> windows;
    for (std::size_t i = outcomes.size(); i < cuts.size() && windows.size() < most; ++i) {
      check_stop();
      ReplacementWindow window = std::move(cuts[i].window);
      windows_.complete(window);
      window.incoming = shapes_for_window(window.box, incoming, settings_.wishes.not_back, period_, shapes_);
      window.drawn = drawn_in(window, all_px2);
      windows.push_back(std::move(window));
    }
    replacer_.post_replace(std::move(windows));
    for (ReplacementOutcome& outcome : replacer_.take_replaced()) outcomes.push_back(std::move(outcome));
  }
  return outcomes;
}

/// The pieces that lie in no window, then those of each window.
std::vector<Placement> Replacing::joined(const std::vector<Placement>& placements, const std::vector<CutWindow>& cuts,
                                         const std::vector<ReplacementOutcome>& outcomes) const {
  std::vector<bool> taken(placements.size(), false);
  for (const CutWindow& c : cuts) {
    for (const std::size_t i : c.moving) taken[i] = true;
  }
  std::vector<Placement> result;
  for (std::size_t i = 0; i < placements.size(); ++i) {
    if (!taken[i]) result.push_back(placements[i]);
  }
  for (std::size_t w = 0; w < cuts.size(); ++w) {
    for (const ReplacedPiece& piece : outcomes.at(w).pieces) {
      Placement p{piece.shape, {}, 0, 0};
      if (piece.from != ReplacedPiece::kNew) p = placements[cuts[w].moving.at(piece.from)];
      p.canvas_from_shape = period_.wrapped(piece.canvas_from_shape);
      result.push_back(p);
    }
  }
  return result;
}

}  // namespace tessera::master
