// The search for sizes at which every piece that is wanted finds a place (fit = "all"): from attempt to attempt all sizes
// are multiplied by another factor. It goes down by what was missing until all have a place, and then up again, halfway
// to the last factor that was too large. Plain numbers in, plain numbers out: the same on every machine.
#pragma once

#include <cstdint>

namespace tessera {

/// All that the search knows; a checkpoint keeps it.
struct SizeSearchState {
  std::uint32_t attempt = 0;  // from 0
  float factor = 1;           // of this attempt, of the sizes of the first one
  float too_large = 0;        // the smallest factor at which a piece found no place; 0: none so far
  float fits = 0;             // the largest factor at which all found a place; 0: none so far
  bool over = true;           // no attempt follows this one

  friend bool operator==(const SizeSearchState&, const SizeSearchState&) = default;
};

class SizeSearch {
 public:
  /// No search: sizes are what they are.
  SizeSearch() = default;
  /// Down to `least_factor`, above 0 and up to 1, and no further.
  explicit SizeSearch(float least_factor) : least_factor_(least_factor) { state_.over = false; }

  float factor() const { return state_.factor; }
  bool over() const { return state_.over; }
  const SizeSearchState& state() const { return state_; }
  /// Whether a search comes to this factor.
  bool knows(float factor) const { return factor >= least_factor_ && factor <= 1; }
  /// Goes on from this state. False where no such search comes to it.
  bool restore(const SizeSearchState& state);

  /// The attempt under way has ended, and so many pieces are missing. `placed`, 0 to 1: the part of all wanted pieces,
  /// by their area, that found a place. Another attempt has begun then, or the search is over.
  void end_attempt(std::uint64_t missing, double placed);
  /// Nothing more is tried, and this factor it is.
  void settle_for(float factor);

 private:
  float smaller(double placed) const;
  float larger(bool raised_before) const;

  float least_factor_ = 1;
  SizeSearchState state_;
};

}  // namespace tessera
