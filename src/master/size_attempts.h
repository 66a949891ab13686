// Attempts to give every wanted piece a place (fit = "all"), each at other sizes, and the best of them so far.
#pragma once

#include <optional>
#include <vector>

#include "core/collage/checkpoint_state.h"
#include "core/matching/size_search.h"
#include "core/settings/settings.h"
#include "master/rules/shortage.h"

namespace tessera::master {

class SizeAttempts {
 public:
  /// Without fit = "all" the first attempt is the only one.
  explicit SizeAttempts(const PieceSettings& pieces);

  /// By what all sizes are multiplied in this attempt.
  float factor() const { return search_.factor(); }
  /// From 1.
  int number() const { return int(search_.state().attempt) + 1; }
  /// No attempt follows this one.
  bool over() const { return search_.over(); }

  /// The attempt under way has ended so. Another one has begun then, or all are over.
  void end_attempt(const Shortage& shortage, const std::vector<Placement>& placements);
  /// The attempt under way has ended so, and no other one is made.
  void give_up(const Shortage& shortage, const std::vector<Placement>& placements);
  /// When all are over: the placements of the best attempt where it is not the last one. factor() is that of the best
  /// attempt from then on.
  std::optional<std::vector<Placement>> take_best();

  void save(CheckpointState& state) const;
  /// False where no job with these settings comes to such a state.
  bool restore(const CheckpointState& state);

 private:
  void keep_if_best(const Shortage& shortage, const std::vector<Placement>& placements);

  SizeSearch search_;
  KeptAttempt best_;
};

}  // namespace tessera::master
