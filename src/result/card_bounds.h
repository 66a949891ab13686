// Limits of a card.json that the program reads back.
#pragma once

#include "text/json_bounds.h"

namespace tessera {

/// A card has some hundred values, and some dozen for each rank.
inline constexpr JsonBounds kCardBounds{.values = 500'000, .levels = 32, .members = 1'000};

}  // namespace tessera
