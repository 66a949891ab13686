// Attempts to give every wanted piece a place (fit = "all"), each at other sizes, and the best attempt so far.
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
  /// Begins the first attempt, which is the only one without fit = "all".
  explicit SizeAttempts(const PieceSettings& pieces);

  /// The factor that multiplies all sizes in the present attempt.
  float factor() const { return search_.factor(); }
  /// The number of the present attempt, from 1.
  int number() const { return int(search_.state().attempt) + 1; }
  /// Whether no other attempt follows.
  bool over() const { return search_.over(); }

  /// Ends the present attempt with this outcome. Then another attempt has begun, or over() is true.
  void end_attempt(const Shortage& shortage, const std::vector<Placement>& placements);
  /// Ends the present attempt with this outcome, and all attempts with it.
  void give_up(const Shortage& shortage, const std::vector<Placement>& placements);
  /// The placements of the best attempt, where it is not the last one; to be called when over() is true. From then on
  /// factor() is that of the best attempt.
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
