#include "master/size_attempts.h"

#include <utility>

#include "core/matching/sized_settings.h"

namespace tessera::master {

SizeAttempts::SizeAttempts(const PieceSettings& pieces)
    : search_(pieces.fit_all ? SizeSearch(least_size_factor(pieces)) : SizeSearch()) {}

void SizeAttempts::keep_if_best(const Shortage& shortage, const std::vector<Placement>& placements) {
  const bool is_best = best_.factor == 0 || shortage.pieces < best_.missing ||
                       (shortage.pieces == best_.missing && factor() > best_.factor);
  if (is_best) best_ = {factor(), shortage.pieces, placements};
}

void SizeAttempts::end_attempt(const Shortage& shortage, const std::vector<Placement>& placements) {
  keep_if_best(shortage, placements);
  search_.end_attempt(shortage.pieces, shortage.placed);
}

void SizeAttempts::give_up(const Shortage& shortage, const std::vector<Placement>& placements) {
  keep_if_best(shortage, placements);
  search_.settle_for(factor());
}

std::optional<std::vector<Placement>> SizeAttempts::take_best() {
  KeptAttempt best = std::exchange(best_, {});
  if (best.factor == 0 || best.factor == factor()) return {};
  search_.settle_for(best.factor);
  return std::move(best.placements);
}

void SizeAttempts::save(CheckpointState& state) const {
  state.sizes = search_.state();
  state.best = best_;
}

bool SizeAttempts::restore(const CheckpointState& state) {
  if (!search_.restore(state.sizes)) return false;
  const KeptAttempt& best = state.best;
  if (best.factor == 0) return best.placements.empty();
  best_ = best;
  return !search_.over() && search_.knows(best.factor) && best.placements.size() >= state.given;
}

}  // namespace tessera::master
