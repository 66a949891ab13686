#include "products/nesting/layout/nesting.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <span>

#include "products/nesting/layout/column_layout.h"
#include "products/nesting/layout/sheet_nesting.h"
#include "products/nesting/layout/strip_nesting.h"

namespace tessera {
namespace {

bool fits(const NestScene& scene, int item) {
  for (int angle = 0; angle < scene.angles_of(item); ++angle) {
    if (scene.fits(scene.shape(item, angle))) return true;
  }
  return false;
}

/// The items of all pieces that fit onto the material; the others become left over.
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

/// One chain: its random numbers, and its reports.
class Chain {
 public:
  Chain(const NestProblem& problem, const PosedItems& shapes, NestRandom& random, const NestFound& found,
        const NestChainWatch& watch)
      : problem_(problem),
        shapes_(shapes),
        random_(random),
        found_(found),
        watch_(watch) {}

  /// Lays the pieces on a strip. `layout` has the left-over pieces.
  void lay_on_strip(const std::vector<int>& pieces, std::uint64_t work_of_piece, NestLayout& layout) {
    report_with_columns(layout, pieces, 0);
    const std::uint64_t most_work = work_of_piece * pieces.size();
    NestScene scene(shapes_, problem_.height, problem_.spacing, watch_of(most_work, 0, 1));
    lay_in_order(scene, pieces, random_, [&](std::span<const int> left) { report_begun(layout, scene, left); });
    shorten(scene, most_work, random_, [&](double) {
      NestLayout shorter = layout;
      take_sheet(scene, shorter);
      report(shorter);
    });
    take_sheet(scene, layout);
    report(layout);
  }

  /// Lays the pieces on sheets. The pieces of the last sheet are pushed together, so that its rest can be used.
  void lay_on_sheets(std::vector<int> pieces, std::uint64_t work_of_piece, NestLayout& layout) {
    const double all = double(pieces.size());
    while (!pieces.empty()) {
      report_with_columns(layout, pieces, 0);
      const std::size_t before = pieces.size();
      // a sheet's budget counts its pieces and all that are still to come
      const std::uint64_t most_work = work_of_piece * before;
      NestScene scene(shapes_, problem_.height, problem_.spacing,
                      watch_of(most_work, 1 - double(before) / all, double(before) / all));
      scene.set_length(problem_.length);
      pieces = fill_sheet(scene, pieces, most_work, random_);
      if (pieces.empty()) {
        scene.set_length(scene.used_length());
        shorten(scene, most_work, random_, {});
      }
      take_sheet(scene, layout);
      if (pieces.size() == before) break;
    }
    for (const int item : pieces) ++layout.left_over[std::size_t(item)];
    report(layout);
  }

 private:
  /// The watch of a scene whose budget is that part of the chain's budget.
  NestWatch watch_of(std::uint64_t most_work, double done_before, double part) {
    if (!watch_) return {};
    return [=, this](std::uint64_t work) {
      const double done = done_before + part * std::min(1.0, double(work) / double(most_work));
      watch_(most_done_ = std::max(most_done_, done));
    };
  }

  void report(const NestLayout& layout) {
    if (!found_ || (best_ && !is_better(layout, *best_))) return;
    best_ = layout;
    found_(layout);
  }

  void report_with_columns(NestLayout layout, const std::vector<int>& left, double from) {
    if (!found_) return;
    columns_.add(left, from, layout);
    report(layout);
  }

  /// Reports a strip on which the first pieces are laid and the rest stand in columns. It does so sixteen times at most,
  /// because the first layout of many pieces is poor.
  void report_begun(NestLayout layout, const NestScene& scene, std::span<const int> left) {
    constexpr std::size_t kTimes = 16;
    const std::size_t step = std::max<std::size_t>(1, (left.size() + std::size_t(scene.size())) / kTimes);
    if (!found_ || left.empty() || left.size() % step != 0) return;
    take_sheet(scene, layout);
    layout.sheets = 0;
    report_with_columns(std::move(layout), {left.begin(), left.end()}, scene.used_length() + problem_.spacing);
  }

  const NestProblem& problem_;
  const PosedItems& shapes_;
  NestRandom& random_;
  const NestFound& found_;
  const NestChainWatch& watch_;
  double most_done_ = 0;
  std::optional<NestLayout> best_;
  const ColumnLayout columns_{problem_};
};

}  // namespace

const NestEffort* nest_effort(const std::string& word) {
  // About 1, 30 and 120 s of one core for each chain, with 40 pieces of 10 corners.
  static constexpr NestEffort kDraft{2, 100'000}, kGood{2, 3'000'000}, kBest{4, 12'000'000};
  return word == "draft" ? &kDraft : word == "good" ? &kGood : word == "best" ? &kBest : nullptr;
}

NestLayout nest_chain(const NestProblem& problem, const PosedItems& shapes, const NestEffort& effort,
                      std::uint64_t seed, int chain, const NestFound& found, const NestChainWatch& watch) {
  NestLayout layout;
  layout.chain = chain;
  layout.left_over.assign(problem.items.size(), 0);
  NestRandom random(mix_bits(seed) + std::uint64_t(chain));
  NestScene material(shapes, problem.height, problem.spacing);
  material.set_length(problem.length);
  const std::vector<int> pieces = pieces_of(material, problem, layout);
  if (pieces.empty()) return layout;
  Chain search(problem, shapes, random, found, watch);
  if (std::isfinite(problem.length))
    search.lay_on_sheets(pieces, effort.work_of_piece, layout);
  else
    search.lay_on_strip(pieces, effort.work_of_piece, layout);
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
