#include <algorithm>

#include "bench/concepts/figures.h"
#include "core/matching/match_round.h"
#include "master/rules/scoring.h"

namespace tessera::bench::concepts {
namespace {

/// The feasible candidates, the most valuable first, by objective and repetition.
std::vector<Candidate> ranked_candidates(CollageStage& stage, const std::vector<RefinedDocking>& refined) {
  master::Scoring scoring(stage.settings(), stage.context().stances);
  for (const Placement& p : stage.collage().placements()) scoring.count(p);
  std::vector<Candidate> candidates;
  for (const RefinedDocking& r : refined) {
    if (!r.feasible) continue;
    Candidate c;
    c.shape = r.docking.shape;
    c.source = r.docking.source;
    c.stance = r.docking.stance;
    c.canvas_from_shape = r.docking.canvas_from_shape;
    c.terms = r.terms;
    c.perimeter = r.perimeter;
    c.radius = r.radius;
    c.score = scoring.score(c) * scoring.preference(c);
    candidates.push_back(c);
  }
  std::stable_sort(candidates.begin(), candidates.end(),
                   [](const Candidate& a, const Candidate& b) { return a.score > b.score; });
  return candidates;
}

/// Matches all target samples again: what is found replaces the pool.
MatchRound matched_again(CollageStage& stage) {
  master::Collage& collage = stage.collage();
  collage.schedule().mark(collage.free().field().value.bounds());
  const std::vector<TargetSample> samples = collage.schedule().take();
  const std::uint64_t pads = pads_per_shape(stage.context()) * stage.context().library_shapes;
  RunStatistics statistics;
  const MatchRound round = match(stage.matcher(), samples, match_plan(stage.settings().match, pads), pads, statistics);
  collage.add_candidates(samples, round);
  return round;
}

bool looks_like_one_of(const std::vector<Candidate>& others, const Candidate& c) {
  return std::any_of(others.begin(), others.end(), [&](const Candidate& o) {
    return o.shape == c.shape && near_copy(o.canvas_from_shape, c.canvas_from_shape, kSameCandidate);
  });
}

std::vector<Candidate> finalists_of(const std::vector<Candidate>& ranked) {
  std::vector<Candidate> finalists;
  for (const Candidate& c : ranked) {
    if (finalists.size() < std::size_t(kFinalists) && !looks_like_one_of(finalists, c)) finalists.push_back(c);
  }
  return finalists;
}

}  // namespace

std::string choice_figure(CollageStage& stage) {
  const std::vector<Candidate> ranked = ranked_candidates(stage, matched_again(stage).refined);
  constexpr float kMargin_px = 16;
  FigureSheet sheet(stage.canvas().width_px + 2 * kMargin_px, stage.canvas().height_px + 2 * kMargin_px + 20);
  const Similarity sheet_from_canvas = scaled_and_moved(1, {kMargin_px, kMargin_px});
  stage.draw(sheet, sheet_from_canvas);
  for (const Candidate& c : ranked)
    stage.draw_roughly(sheet, sheet_from_canvas, c.shape, c.canvas_from_shape,
                       {.stroke = kPaleInk, .width_px = 0.6, .opacity = 0.35});
  for (const Candidate& c : finalists_of(ranked))
    stage.draw_piece(sheet, sheet_from_canvas, c.shape, c.canvas_from_shape, {.stroke = kOrange, .width_px = 1.6});
  master::Collage& collage = stage.collage();
  Candidate best;
  while (collage.choose(best)) {
    stage.draw_piece(sheet, sheet_from_canvas, best.shape, best.canvas_from_shape,
                     {.stroke = kGreen, .width_px = 2.4, .fill = "#009e7340"});
    collage.place(best);
  }
  stage.place(collage.placements().size());
  sheet.text({kMargin_px, float(stage.canvas().height_px) + 2 * kMargin_px + 8},
             "grey: " + std::to_string(ranked.size()) + " candidates; orange: the " + std::to_string(kFinalists) +
                 " finalists; green: the pieces that are placed");
  return sheet.finish();
}

}  // namespace tessera::bench::concepts
