#include "core/nesting/nesting.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/nesting/sheet_nesting.h"
#include "core/nesting/strip_nesting.h"

namespace tessera {
namespace {

bool fits(const NestScene& scene, int item) {
  for (int angle = 0; angle < scene.angles_of(item); ++angle) {
    if (scene.fits(scene.shape(item, angle))) return true;
  }
  return false;
}

/// The items of all pieces that can lie somewhere; the others are left over.
std::vector<int> pieces_of(const NestScene& scene, const NestProblem& problem, NestLayout& layout) {
  std::vector<int> pieces;
  for (int item = 0; item < int(problem.items.size()); ++item) {
    const int demand = problem.items[std::size_t(item)].demand;
    if (fits(scene, item))
      pieces.insert(pieces.end(), std::size_t(demand), item);
    else
      layout.left_over[std::size_t(item)] = demand;
  }
  return pieces;
}

void take_sheet(const NestScene& scene, NestLayout& layout) {
  for (int i = 0; i < scene.size(); ++i)
    layout.pieces.push_back({scene.item(i), scene.pose(i).angle, scene.pose(i).shift, layout.sheets});
  ++layout.sheets;
  layout.used_length = scene.used_length();
}

/// What is on the last sheet moves together, so that what is left of it can be used.
void nest_on_sheets(const NestProblem& problem, const PosedItems& shapes, std::vector<int> pieces,
                    std::uint64_t work_of_piece, NestRandom& random, const NestProgress& progress,
                    const NestWatch& watch, NestLayout& layout) {
  while (!pieces.empty()) {
    NestScene scene(shapes, problem.height, problem.spacing, watch);
    scene.set_length(problem.length);
    const std::size_t before = pieces.size();
    const std::uint64_t most_work = work_of_piece * before;  // a sheet has as much as its pieces and those to come
    pieces = fill_sheet(scene, pieces, most_work, random);
    if (pieces.empty()) {
      scene.set_length(scene.used_length());
      shorten(scene, most_work, random, {});
    }
    take_sheet(scene, layout);
    if (progress) progress(layout.sheets, layout.used_length);
    if (pieces.size() == before) break;
  }
  for (const int item : pieces) ++layout.left_over[std::size_t(item)];
}

}  // namespace

const NestEffort* nest_effort(const std::string& word) {
  // About 1, 30 and 120 s of one core for 40 pieces of 10 corners, a chain.
  static constexpr NestEffort kDraft{2, 100'000}, kGood{2, 3'000'000}, kBest{4, 12'000'000};
  return word == "draft" ? &kDraft : word == "good" ? &kGood : word == "best" ? &kBest : nullptr;
}

NestLayout nest_chain(const NestProblem& problem, const PosedItems& shapes, const NestEffort& effort,
                      std::uint64_t seed, int chain, const NestProgress& progress, const NestWatch& watch) {
  NestLayout layout;
  layout.chain = chain;
  layout.left_over.assign(problem.items.size(), 0);
  NestRandom random(mix_bits(seed) + std::uint64_t(chain));
  NestScene scene(shapes, problem.height, problem.spacing, watch);
  scene.set_length(problem.length);
  const std::vector<int> pieces = pieces_of(scene, problem, layout);
  const std::uint64_t most_work = effort.work_of_piece * pieces.size();
  if (pieces.empty()) return layout;
  if (std::isfinite(problem.length)) {
    nest_on_sheets(problem, shapes, pieces, effort.work_of_piece, random, progress, watch, layout);
  } else {
    lay_in_order(scene, pieces, random);
    shorten(scene, most_work, random, [&](double length) {
      if (progress) progress(0, length);
    });
    take_sheet(scene, layout);
  }
  return layout;
}

bool is_better(const NestLayout& a, const NestLayout& b) {
  const auto left = [](const NestLayout& layout) {
    return std::accumulate(layout.left_over.begin(), layout.left_over.end(), 0);
  };
  if (left(a) != left(b)) return left(a) < left(b);
  if (a.sheets != b.sheets) return a.sheets < b.sheets;
  if (a.used_length != b.used_length) return a.used_length < b.used_length;
  return a.chain < b.chain;
}

const NestLayout& best_layout(const std::vector<NestLayout>& layouts) {
  return *std::min_element(layouts.begin(), layouts.end(), is_better);
}

}  // namespace tessera
