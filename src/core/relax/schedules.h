// The relaxation of a whole collage before make_clear (clearing.h). These numbers left most coverage after make_clear
// on 1,000 x 1,000 px with 185 animals of 60 to 120 and of 20 to 160 px.
#pragma once

#include <algorithm>
#include <array>

#include "core/relax/relaxation.h"
#include "core/settings/settings.h"

namespace tessera {

/// Grows from soft to stiff contacts: at 0.5 pieces lie 2 px deep in each other and still slip past tips. If softer,
/// neighbours would swallow dwarfs. Steps above 4 px would make pieces leap into others.
inline constexpr RelaxationSchedule kGrowTogether{60, 0.5f, 5, 4, 0.3f};
/// Ends at a stiffness of 12. At 5, pieces of 20 to 160 px would cover 0.3 % more of the canvas, but 0.12 % more of it
/// twice.
inline constexpr RelaxationSchedule kConverge{40, 5, 12, 1, 0.2f};
/// Tips have little boundary, so they lie deep, and only the hard stiffness draws them out. If it were larger, pieces
/// would stop growing.
inline constexpr RelaxationSchedule kResolveDepth{60, 12, 12, 1, 0.1f, 200};
inline constexpr std::array kRelaxCollage = {kGrowTogether, kGrowTogether, kConverge, kResolveDepth};
/// The schedules for pieces whose poses are good already.
inline constexpr std::array kSettleCollage = {kConverge, kResolveDepth};

/// The distances at which contact begins and becomes hard: slightly before PlacedOutlines finds a conflict, as fields
/// do not show all of an outline.
inline ContactDistances contact_distances(const PieceSettings& pieces) {
  constexpr float kSoftBefore_px = 0.3f;
  constexpr float kHardBefore_px = 0.1f;
  const float needed_px = pieces.padding_px > 0 ? pieces.padding_px : -pieces.overlap_px;
  return {std::max(0.f, needed_px + kSoftBefore_px), needed_px + kHardBefore_px};
}

}  // namespace tessera
