#include "core/matching/size_search.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/settings/tuning.h"

namespace tessera {
namespace {

/// Upper bounds for the ratio of the next factor to the present one, by the number of failed attempts. The first steps
/// are small, as a few missing pieces need little. Later steps are larger, so that the least factor is tried in any
/// case.
constexpr std::array kLargestStep = {0.98f, 0.96f, 0.93f, 0.89f, 0.83f, 0.75f, 0.65f, 0.5f, 0.35f};
static_assert(kLargestStep.size() + 3 <= kMostAttempts, "one for the least factor and one for a larger one are left");
constexpr float kSmallestStep = 0.5f;
/// The missing area is multiplied by this: pieces found no place although some room was left, so they need more than
/// their area.
constexpr double kMoreThanMissing = 1.25;
/// The search goes up once if the ratio of the known bounds of the largest possible factor exceeds kNearFactors, and
/// again only if it exceeds kFarFactors.
constexpr float kNearFactors = 1.01f;
constexpr float kFarFactors = 1.1f;

}  // namespace

bool SizeSearch::restore(const SizeSearchState& state) {
  const auto known_if_any = [&](float factor) { return factor == 0 || knows(factor); };
  if (state.attempt >= kMostAttempts || !knows(state.factor)) return false;
  if (!known_if_any(state.too_large) || !known_if_any(state.fits)) return false;
  if (state_.over && state != state_) return false;  // the state of a job that searches; this one does not
  state_ = state;
  return true;
}

void SizeSearch::end_attempt(std::uint64_t missing, double placed) {
  const bool raised_before = state_.fits > 0;
  (missing == 0 ? state_.fits : state_.too_large) = state_.factor;
  const float next = state_.fits > 0 ? larger(raised_before) : smaller(placed);
  state_.over = next == state_.factor || state_.attempt + 1 == kMostAttempts;
  if (state_.over) return;
  ++state_.attempt;
  state_.factor = next;
}

void SizeSearch::settle_for(float factor) {
  state_.factor = factor;
  state_.over = true;
}

/// The next factor, smaller than the present one. Sizes times s cover s² as much.
float SizeSearch::smaller(double placed) const {
  if (state_.attempt >= kLargestStep.size()) return least_factor_;
  const float step = float(1 - kMoreThanMissing * (1 - std::sqrt(std::max(0., placed))));
  return std::max(least_factor_, state_.factor * std::min(kLargestStep[state_.attempt], std::max(kSmallestStep, step)));
}

/// The next factor, larger than the one that fits; the present factor if there is nothing to gain.
float SizeSearch::larger(bool raised_before) const {
  const float apart = raised_before ? kFarFactors : kNearFactors;
  if (state_.too_large <= apart * state_.fits) return state_.factor;
  return std::sqrt(state_.fits * state_.too_large);
}

}  // namespace tessera
