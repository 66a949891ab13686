// The search for sizes at which every wanted piece finds a place (fit = "all"). Each attempt multiplies all sizes by
// another factor. The factor falls, by an amount that follows from the missing pieces, until all pieces have a place.
// Then the search tries the geometric mean of that factor and the last one that was too large. Plain numbers in, plain
// numbers out: the same on every machine.
#pragma once

#include <cstdint>

namespace tessera {

/// The whole state of the search; a checkpoint keeps it.
struct SizeSearchState {
  std::uint32_t attempt = 0;  // from 0
  float factor = 1;           // of this attempt, relative to the sizes of the first one
  float too_large = 0;        // the smallest factor at which a piece found no place; 0: none so far
  float fits = 0;             // the largest factor at which all found a place; 0: none so far
  bool over = true;           // no attempt follows this one

  friend bool operator==(const SizeSearchState&, const SizeSearchState&) = default;
};

class SizeSearch {
 public:
  /// No search: the factor stays 1.
  SizeSearch() = default;
  /// A search that goes down to `least_factor`, which is above 0 and at most 1.
  explicit SizeSearch(float least_factor) : least_factor_(least_factor) { state_.over = false; }

  float factor() const { return state_.factor; }
  bool over() const { return state_.over; }
  const SizeSearchState& state() const { return state_; }
  /// Whether the factor lies in the range of the search.
  bool knows(float factor) const { return factor >= least_factor_ && factor <= 1; }
  /// Continues from this state. False if a search with this range cannot reach the state.
  bool restore(const SizeSearchState& state);

  /// Ends the attempt under way. `missing`: number of pieces without a place. `placed`, 0 to 1: the fraction of all
  /// wanted pieces, by area, that found a place. Afterwards another attempt has begun, or the search is over.
  void end_attempt(std::uint64_t missing, double placed);
  /// Ends the search with this factor.
  void settle_for(float factor);

 private:
  float smaller(double placed) const;
  float larger(bool raised_before) const;

  float least_factor_ = 1;
  SizeSearchState state_;
};

}  // namespace tessera
