// What a card.json may have that is read again.
#pragma once

#include "text/json_bounds.h"

namespace tessera {

/// Some hundred values, and some dozen for each rank.
inline constexpr JsonBounds kCardBounds{.values = 500'000, .levels = 32, .members = 1'000};

}  // namespace tessera
