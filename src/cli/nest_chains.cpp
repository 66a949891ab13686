#include "cli/nest_chains.h"

#include <memory>
#include <mutex>
#include <vector>

#include "comm/encode.h"
#include "core/base/interrupted.h"
#include "io/parallel_for.h"

#include <boost/serialization/vector.hpp>

namespace tessera::cli {
namespace {

/// Everything as numbers, whole ones below 2^53.
using Numbers = std::vector<double>;

class Taker {
 public:
  explicit Taker(Numbers numbers) : numbers_(std::move(numbers)) {}
  double next() { return numbers_.at(at_++); }
  int whole() { return int(next()); }

 private:
  Numbers numbers_;
  std::size_t at_ = 0;
};

Numbers numbers_of(const NestProblem& problem, const NestEffort& effort, std::uint64_t seed) {
  Numbers out{double(effort.chains), double(effort.work_of_piece),
              double(seed >> 32),    double(seed & 0xffffffffu),
              problem.height,        problem.length,
              problem.spacing,       double(problem.items.size())};
  for (const NestItem& item : problem.items) {
    out.insert(out.end(), {double(item.demand), double(item.angles_deg.size()), double(item.outline.size())});
    out.insert(out.end(), item.angles_deg.begin(), item.angles_deg.end());
    for (const NestPoint p : item.outline) out.insert(out.end(), {p.x, p.y});
  }
  return out;
}

NestProblem problem_of(Taker& in, NestEffort& effort, std::uint64_t& seed) {
  effort.chains = in.whole();
  effort.work_of_piece = std::uint64_t(in.next());
  const std::uint64_t high = std::uint64_t(in.next());
  seed = (high << 32) | std::uint64_t(in.next());
  NestProblem problem;
  problem.height = in.next();
  problem.length = in.next();
  problem.spacing = in.next();
  problem.items.resize(std::size_t(in.next()));
  for (NestItem& item : problem.items) {
    item.demand = in.whole();
    item.angles_deg.resize(std::size_t(in.next()));
    item.outline.resize(std::size_t(in.next()));
    for (double& angle : item.angles_deg) angle = in.next();
    for (NestPoint& p : item.outline) {
      p.x = in.next();
      p.y = in.next();
    }
  }
  return problem;
}

Numbers numbers_of(const NestLayout& layout) {
  Numbers out{double(layout.chain), double(layout.sheets), layout.used_length, double(layout.left_over.size()),
              double(layout.pieces.size())};
  out.insert(out.end(), layout.left_over.begin(), layout.left_over.end());
  for (const NestedPiece& piece : layout.pieces) {
    out.insert(out.end(), {double(piece.item), double(piece.angle), piece.shift.x, piece.shift.y, double(piece.sheet)});
  }
  return out;
}

NestLayout layout_of(Taker in) {
  NestLayout layout;
  layout.chain = in.whole();
  layout.sheets = in.whole();
  layout.used_length = in.next();
  layout.left_over.resize(std::size_t(in.next()));
  layout.pieces.resize(std::size_t(in.next()));
  for (int& count : layout.left_over) count = in.whole();
  for (NestedPiece& piece : layout.pieces) {
    piece.item = in.whole();
    piece.angle = in.whole();
    piece.shift.x = in.next();
    piece.shift.y = in.next();
    piece.sheet = in.whole();
  }
  return layout;
}

/// The best of chains first, first + step and so on. `any` becomes false where there are none.
NestLayout best_of(const NestProblem& problem, const NestEffort& effort, std::uint64_t seed, int first, int step,
                   const NestProgress& progress, const NestWatch& watch, bool& any) {
  std::vector<NestLayout> layouts;
  for (int chain = first; chain < effort.chains; chain += step) layouts.emplace_back();
  any = !layouts.empty();
  if (!any) return {};
  const PosedItems shapes = posed_items(problem);
  io::parallel_for(layouts.size(), [&](std::size_t i) {
    layouts[i] = nest_chain(problem, shapes, effort, seed, first + int(i) * step, progress, watch);
  });
  return best_layout(layouts);
}

/// For any thread of the rank, one at a time: throws where the job is over.
NestWatch look_of(comm::Communicator& ranks) {
  return [&ranks, mutex = std::make_shared<std::mutex>()] {
    const std::lock_guard lock(*mutex);
    ranks.look();
  };
}

}  // namespace

NestLayout best_nesting(comm::Communicator& ranks, const NestProblem& problem, const NestEffort& effort,
                        std::uint64_t seed, const NestProgress& progress,
                        const std::function<const char*()>& stop_reason) {
  ranks.broadcast(comm::encode(numbers_of(problem, effort, seed)));
  std::mutex mutex;
  const NestProgress one_at_a_time = [&](int sheet, double length) {
    const std::lock_guard lock(mutex);
    progress(sheet, length);
  };
  ranks.interrupt_waits_when(stop_reason);
  const NestWatch watch = [&, look = look_of(ranks)] {
    look();
    if (const char* reason = stop_reason()) throw Interrupted{reason};
  };
  bool any = false;
  std::vector<NestLayout> of_ranks{best_of(problem, effort, seed, 0, ranks.size(), one_at_a_time, watch, any)};
  for (int rank = 1; rank < ranks.size() && rank < effort.chains; ++rank)
    of_ranks.push_back(layout_of(Taker(comm::decode<Numbers>(ranks.receive(rank, comm::Tag::nest_layout)))));
  return best_layout(of_ranks);
}

void work_on_nesting(comm::Communicator& ranks) {
  Taker in(comm::decode<Numbers>(ranks.broadcast({})));
  NestEffort effort;
  std::uint64_t seed = 0;
  const NestProblem problem = problem_of(in, effort, seed);
  bool any = false;
  const NestLayout best = best_of(problem, effort, seed, ranks.rank(), ranks.size(), {}, look_of(ranks), any);
  if (any) ranks.send(0, comm::Tag::nest_layout, comm::encode(numbers_of(best)));
}

}  // namespace tessera::cli
