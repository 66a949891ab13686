// How well a mosaic shows its picture from afar: the section in the cards, which `tessera card` prints, too.
#pragma once

#include <optional>
#include <string>

#include "core/colour/seen_from_afar.h"

namespace tessera {

/// The figures that tell how well the drawn collage shows its picture from afar, or why there are none.
struct AfarNote {
  std::optional<SeenFromAfar> seen;
  std::string not_measured;  // why there are no figures
};

/// Section "from_afar" of card.json (docs/result-format.md), as JSON.
std::string afar_json(const AfarNote& note);

/// The first line of afar_text().
inline constexpr const char* kAfarHeading = "Seen from afar\n";

/// The section of card.txt. Lines have less than 80 characters, unless names of files are longer.
std::string afar_text(const AfarNote& note);

}  // namespace tessera
