// How a whole collage is relaxed before make_clear (clearing.h). The numbers are those that left
// most coverage after make_clear on 1,000 x 1,000 px with 185 animals of 60 to 120 and of 20 to 160 px.
#pragma once

#include <algorithm>
#include <array>

#include "core/relax/relaxation.h"
#include "core/settings/settings.h"

namespace tessera {

/// From soft to stiff: at 0.5 pieces lie 2 px deep in each other and still slip past tips; softer, dwarfs are swallowed
/// by their neighbours. Steps longer than 4 px make pieces leap into others.
inline constexpr RelaxationSchedule kGrowTogether{60, 0.5f, 5, 4, 0.3f};
/// Less stiff, at 5, 0.3 % of the canvas more is covered by 20 to 160 px, and 0.12 % more of it twice.
inline constexpr RelaxationSchedule kComeToRest{40, 5, 12, 1, 0.2f};
/// Tips weigh little, so that they lie deep: only what is hard draws them out. Stiffer, pieces stop growing.
inline constexpr RelaxationSchedule kKeepTheRule{60, 12, 12, 1, 0.1f, 200};
inline constexpr std::array kRelaxCollage = {kGrowTogether, kGrowTogether, kComeToRest, kKeepTheRule};
/// For pieces that came to lie well already.
inline constexpr std::array kSettleCollage = {kComeToRest, kKeepTheRule};

/// Where contact begins, and from where on it is hard: a little before PlacedOutlines sees a conflict, as fields do not
/// see all of an outline.
inline ContactDistances contact_distances(const PieceSettings& pieces) {
  constexpr float kSoftBefore_px = 0.3f;
  constexpr float kHardBefore_px = 0.1f;
  const float needed_px = pieces.padding_px > 0 ? pieces.padding_px : -pieces.overlap_px;
  return {std::max(0.f, needed_px + kSoftBefore_px), needed_px + kHardBefore_px};
}

}  // namespace tessera
