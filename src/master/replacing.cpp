#include "master/replacing.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "core/base/stop.h"
#include "core/matching/use_limits.h"
#include "core/relax/schedules.h"
#include "core/replacing/draws.h"
#include "core/replacing/window_cuts.h"
#include "master/kept_apart.h"
#include "master/relaxing.h"

namespace tessera::master {
namespace {

constexpr std::uint64_t kReplace = 0x7265706c;  // keeps these random numbers apart from others
constexpr float kWindowSizes = 6;               // a window is so many middle sizes wide, or
constexpr float kWindowLargest = 3;             // so many of the largest
constexpr float kTrialsPerPiece = 2;            // of a batch
constexpr float kBeside = 0.5f;                 // of the middle size: pieces so near to a window are seen from inside
constexpr float kBeyond_px = 64;                // of the canvas' nodes: nothing lies farther outside
constexpr float kLeastEdgeNode_px = 2;
constexpr float kEdgeNodesPerScale = 32;    // of the least: the edge of large pieces needs no more
constexpr float kFarFromEdge_px = 64;       // holes look no farther; contacts do where pieces keep away from it
constexpr float kFirstTemperature = 0.03f;  // of the product of least and most scale
/// Of repetition_exponent: at its default, 0.3, there are more shapes by area than by ruin and recreate alone.
constexpr double kRepetition = 0.1;
constexpr double kNearness = 1;             // likewise: hardly two large copies lie within three of their sizes
constexpr float kMostNearSizes = 5;         // away nobody sees copies together
constexpr std::size_t kMostIncoming = 400;  // shapes, of a larger library

float middle_px(const PieceSettings& p) { return std::sqrt(p.min_scale_px * p.max_scale_px); }

Box canvas_box(const FreeField& free) {
  const Window& nodes = free.grid().one_period();
  const Vec2 origin = free.field().origin;
  Box box{origin + Vec2{float(nodes.x0), float(nodes.y0)}, origin + Vec2{float(nodes.x1), float(nodes.y1)}};
  const Period& period = free.grid().period();
  const Vec2 beyond{period.x_px > 0 ? 0 : kBeyond_px, period.y_px > 0 ? 0 : kBeyond_px};
  return {box.low - beyond, box.high + beyond};
}

bool holds(const Box& outer, const Box& inner) {
  return inner.low.x >= outer.low.x && inner.low.y >= outer.low.y && inner.high.x <= outer.high.x &&
         inner.high.y <= outer.high.y;
}

/// Fills in what of these nodes is less than far from the edge; whether there is anything. Halves what may hold both:
/// a raster of all would be most of the master's work.
bool fill_near_edge(const EdgeDistance& canvas, const Window& nodes, float far_px, EdgeField& edge) {
  const auto at = [&](float x, float y) { return canvas.at((edge.distance.origin + Vec2{x, y}) * edge.node_px).value; };
  const Vec2 half{0.5f * float(nodes.x1 - nodes.x0 - 1), 0.5f * float(nodes.y1 - nodes.y0 - 1)};
  const float middle_px = at(float(nodes.x0) + half.x, float(nodes.y0) + half.y);
  if (middle_px - norm(half) * edge.node_px > far_px) return false;
  constexpr int kSmall = 8;
  if (nodes.x1 - nodes.x0 > kSmall || nodes.y1 - nodes.y0 > kSmall) {
    const bool wide = half.x > half.y;
    const int x = wide ? (nodes.x0 + nodes.x1) / 2 : nodes.x1, y = wide ? nodes.y1 : (nodes.y0 + nodes.y1) / 2;
    const bool first = fill_near_edge(canvas, {nodes.x0, nodes.y0, x, y}, far_px, edge);
    const bool second =
        fill_near_edge(canvas, {wide ? x : nodes.x0, wide ? nodes.y0 : y, nodes.x1, nodes.y1}, far_px, edge);
    return first || second;
  }
  bool any = false;
  for (int y = nodes.y0; y < nodes.y1; ++y) {
    for (int x = nodes.x0; x < nodes.x1; ++x) {
      float& value = edge.distance.value(x, y);
      value = std::min(far_px, at(float(x), float(y)));
      any = any || value < far_px;
    }
  }
  return any;
}

}  // namespace

bool pays_to_replace(const CollageSettings& s) {
  return pays_to_relax(s) && !UseLimits(s.pieces, s.wishes).any() && !any_kept_apart(s) && s.colour.neighbours == 0 &&
         s.stop.pieces == 0 && !s.start.grow_outward;
}

std::size_t drawings_of(const StanceTable& stances, const ShapeSource& shapes) {
  std::vector<ShapeId> drawings;
  for (std::uint32_t i = 0; i < stances.open_shapes(); ++i)
    drawings.push_back(shapes.silhouette(stances.open_shape(i)));
  std::sort(drawings.begin(), drawings.end());
  return std::size_t(std::unique(drawings.begin(), drawings.end()) - drawings.begin());
}

RepetitionCosts repetition_costs(const CollageSettings& settings, std::size_t drawings, double area_px2) {
  const PieceSettings& pieces = settings.pieces;
  const double middle_px2 = double(pieces.min_scale_px) * double(pieces.max_scale_px);
  const double exponent = double(settings.objective.repetition_exponent);
  RepetitionCosts costs;
  costs.area = kRepetition * exponent;
  costs.even_share_px2 = std::max(middle_px2, drawings > 0 ? area_px2 / double(drawings) : 0);
  costs.nearness = kNearness * exponent;
  costs.reach_sizes = std::min(kMostNearSizes, 0.5f * std::sqrt(float(drawings)));
  return costs;
}

float least_window_px(const PieceSettings& pieces) {
  return std::max(kWindowSizes * middle_px(pieces), kWindowLargest * pieces.max_scale_px);
}

Replacing::Replacing(const FreeField& free, const StanceTable& stances, const CollageSettings& settings,
                     double area_px2, ShapeSource& shapes, PosesOf poses_of, Replacer& replacer)
    : free_(free),
      stances_(stances),
      settings_(settings),
      repetition_(repetition_costs(settings, drawings_of(stances, shapes), area_px2)),
      shapes_(shapes),
      poses_of_(std::move(poses_of)),
      replacer_(replacer) {}

std::vector<Replacing::Lying> Replacing::lying(const std::vector<Placement>& placements,
                                               const StopCheck& check_stop) const {
  std::vector<Lying> all;
  for (const Placement& p : placements) {
    check_stop();
    std::vector<Vec2> points;
    for (const Vec2 point : shapes_.model(p.shape).boundary) points.push_back(p.canvas_from_shape.apply(point));
    all.push_back({{p.shape, shapes_.silhouette(p.shape), p.canvas_from_shape, poses_of_(p)}, bounding_box(points)});
  }
  return all;
}

EdgeField Replacing::edge_around(const Box& box) const {
  const Vec2 beyond{settings_.pieces.max_scale_px, settings_.pieces.max_scale_px};
  const Box seen{box.low - beyond, box.high + beyond};
  const EdgeDistance canvas(free_);
  const float node_px = std::max(kLeastEdgeNode_px, settings_.pieces.min_scale_px / kEdgeNodesPerScale);
  const auto node = [node_px](float at_px) { return int(std::floor(at_px / node_px)); };
  const int x0 = node(seen.low.x), x1 = node(seen.high.x) + 2;
  const int y0 = node(seen.low.y), y1 = node(seen.high.y) + 2;
  const float far_px = std::max(kFarFromEdge_px, contact_distances(settings_.pieces).reach_px() + 4 * node_px);
  EdgeField edge{{Grid<float>(x1 - x0, y1 - y0, far_px), {float(x0), float(y0)}}, node_px};
  if (fill_near_edge(canvas, {0, 0, x1 - x0, y1 - y0}, far_px, edge)) return edge;
  // Most windows of a large canvas: nothing in them feels the edge.
  const float across_px = std::max(seen.width(), seen.height());
  return {{Grid<float>(3, 3, kNoEdge_px), seen.low * (1 / across_px)}, across_px};
}

/// All of a small library's; as many of a large one's as a rank can look at.
std::vector<IncomingShape> Replacing::drawn_shapes(std::uint64_t random) const {
  std::vector<IncomingShape> all;
  Draws draws(random);
  const std::size_t open = stances_.open_shapes();
  const std::size_t count = std::min(open, kMostIncoming);
  float most_weight = 0;
  for (std::size_t k = 0; k < count; ++k) {
    const ShapeId shape = stances_.open_shape(std::uint32_t(open > kMostIncoming ? draws.below(open) : k));
    for (const Stance& stance : stances_.of(stances_.list(shape))) {
      all.push_back({shape, shapes_.silhouette(shape), stance.poses, stance.weight});
      most_weight = std::max(most_weight, stance.weight);
    }
  }
  for (IncomingShape& in : all) in.weight /= most_weight;
  return all;
}

/// But for what lay there and is not to come back: what comes in is not asked where exactly it lies, until it is
/// settled. Where too few would be left, all.
std::vector<IncomingShape> Replacing::let_into(const Box& box, const std::vector<IncomingShape>& incoming) const {
  const Vec2 middle = (box.low + box.high) * 0.5f;
  std::set<ShapeId> lay_there;
  for (const FormerPiece& piece : settings_.wishes.not_back) {
    const Vec2 at = free_.grid().period().nearest(piece.canvas_from_shape.translation(), middle);
    if (within_reach(box, {at, at}, 0.5f * piece.canvas_from_shape.scale()))
      lay_there.insert(shapes_.silhouette(piece.shape));
  }
  std::vector<IncomingShape> let_in;
  for (const IncomingShape& in : incoming) {
    if (!lay_there.contains(in.drawing)) let_in.push_back(in);
  }
  return 2 * let_in.size() < incoming.size() ? incoming : let_in;
}

/// What the drawings of the window cover, of all that each covers.
std::vector<DrawingArea> Replacing::drawn_in(const ReplacementWindow& window,
                                             const std::map<ShapeId, double>& all_px2) const {
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

/// All that the job and the canvas say of a window that is cut.
void Replacing::complete(ReplacementWindow& window) const {
  window.edge = edge_around(window.box);
  window.distances = contact_distances(settings_.pieces);
  window.least_scale_px = settings_.pieces.min_scale_px;
  window.most_scale_px = settings_.pieces.max_scale_px;
  window.repetition = repetition_;
}

/// The pieces but for some that may be felt as copies in the box, and their images on a seamless canvas.
std::vector<PlacedDrawing> Replacing::copies_around(const Box& box, const std::vector<Lying>& all,
                                                    const std::vector<std::size_t>& but) const {
  const float reach_px = repetition_.reach_sizes * settings_.pieces.max_scale_px;
  const std::vector<Vec2> offsets = free_.grid().period().offsets();
  std::vector<PlacedDrawing> around;
  auto skipped = but.begin();
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (skipped != but.end() && *skipped == i) {
      ++skipped;
      continue;
    }
    for (const Vec2 offset : offsets) {
      PlacedDrawing piece = placed_drawing(all[i].piece.drawing, all[i].piece.canvas_from_shape);
      piece.centre_px = piece.centre_px + offset;
      if (within_reach(box, {piece.centre_px, piece.centre_px}, reach_px)) around.push_back(piece);
    }
  }
  return around;
}

/// All pieces that lie in the window as a whole may move, but for the given ones.
Replacing::Cut Replacing::cut(const Box& box, const std::vector<Lying>& all, std::size_t given) const {
  Cut made;
  made.window.box = box;
  const std::vector<Vec2> offsets = free_.grid().period().offsets();
  for (std::size_t i = 0; i < all.size(); ++i) {
    for (const Vec2 offset : offsets) {
      const Box lies{all[i].box.low + offset, all[i].box.high + offset};
      if (!within_reach(box, lies, kBeside * middle_px(settings_.pieces))) continue;
      WindowPiece piece = all[i].piece;
      piece.canvas_from_shape = moved(piece.canvas_from_shape, offset);
      if (i >= given && holds(box, lies)) {
        made.moving.push_back(i);
        made.window.moving.push_back(piece);
      } else {
        made.window.still.push_back(piece);
      }
    }
  }
  made.window.elsewhere = copies_around(box, all, made.moving);
  made.window.trials = std::uint32_t(std::ceil(kTrialsPerPiece * float(made.moving.size())));
  return made;
}

std::vector<Replacing::Cut> Replacing::cut_all(const std::vector<Lying>& all, std::size_t given, std::uint64_t key,
                                               const StopCheck& check_stop) const {
  Draws draws(key);
  const float part_x = draws.unit();
  const float part_y = draws.unit();
  std::vector<Cut> cuts;
  for (const Box& box :
       cut_into_windows(canvas_box(free_), free_.grid().period(), least_window_px(settings_.pieces), part_x, part_y)) {
    check_stop();
    Cut made = cut(box, all, given);
    if (made.moving.empty()) continue;
    made.window.random = mix_bits(key ^ cuts.size());
    cuts.push_back(std::move(made));
  }
  return cuts;
}

/// Sets how many trials there are, no more than are left, and how hot it is.
void Replacing::plan(std::vector<Cut>& cuts, ReplacementProgress& progress) const {
  const auto count = [&] {
    std::uint64_t trials = 0;
    for (const Cut& c : cuts) trials += c.window.trials;
    return trials;
  };
  const std::uint64_t left = progress.all - progress.done;
  const std::uint64_t wanted = count();
  if (wanted > left) {
    for (Cut& c : cuts) c.window.trials = std::uint32_t(std::uint64_t(c.window.trials) * left / wanted);
  }
  const auto temperature_px2 = [&](std::uint64_t done) {
    const float hottest = kFirstTemperature * settings_.pieces.min_scale_px * settings_.pieces.max_scale_px;
    return hottest * float(1 - double(done) / double(progress.all));
  };
  const std::uint64_t done = progress.done + count();
  for (Cut& c : cuts) {
    c.window.first_temperature_px2 = temperature_px2(progress.done);
    c.window.last_temperature_px2 = temperature_px2(done);
  }
  // A batch that shared out nothing, or in which nothing may move, is the last one.
  progress.done = done > progress.done ? done : progress.all;
}

std::vector<Placement> Replacing::batch(const std::vector<Placement>& placements, std::size_t given,
                                        ReplacementProgress& progress, const StopCheck& check_stop) {
  const std::uint64_t key = mix_bits(settings_.seed ^ mix_bits(kReplace ^ (progress.done << 24)));
  const std::vector<Lying> all = lying(placements, check_stop);
  std::vector<Cut> cuts = cut_all(all, given, key, check_stop);
  ReplacementProgress after = progress;
  plan(cuts, after);
  const std::vector<ReplacementOutcome> outcomes = asked(cuts, all, drawn_shapes(key), check_stop);
  progress = after;
  return joined(placements, cuts, outcomes);
}

/// A few windows for each that is worked on at a time: no question lasts long, or needs the memory of all windows.
std::vector<ReplacementOutcome> Replacing::asked(std::vector<Cut>& cuts, const std::vector<Lying>& all,
                                                 const std::vector<IncomingShape>& incoming,
                                                 const StopCheck& check_stop) {
  std::map<ShapeId, double> covered_px2;
  for (const Lying& l : all) {
    const double scale_px = double(l.piece.canvas_from_shape.scale());
    covered_px2[l.piece.drawing] += scale_px * scale_px;
  }
  const std::size_t most = kWindowsAtATime * std::size_t(replacer_.breadth());
  std::vector<ReplacementOutcome> outcomes;
  while (outcomes.size() < cuts.size()) {
    std::vector<ReplacementWindow> windows;
    for (std::size_t i = outcomes.size(); i < cuts.size() && windows.size() < most; ++i) {
      check_stop();
      ReplacementWindow window = std::move(cuts[i].window);
      complete(window);
      window.incoming = let_into(window.box, incoming);
      window.drawn = drawn_in(window, covered_px2);
      windows.push_back(std::move(window));
    }
    replacer_.post_replace(std::move(windows));
    for (ReplacementOutcome& outcome : replacer_.take_replaced()) outcomes.push_back(std::move(outcome));
  }
  return outcomes;
}

/// The pieces of no window, then those of each.
std::vector<Placement> Replacing::joined(const std::vector<Placement>& placements, const std::vector<Cut>& cuts,
                                         const std::vector<ReplacementOutcome>& outcomes) const {
  std::vector<bool> taken(placements.size(), false);
  for (const Cut& c : cuts) {
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
      p.canvas_from_shape = free_.grid().period().wrapped(piece.canvas_from_shape);
      result.push_back(p);
    }
  }
  return result;
}

}  // namespace tessera::master
