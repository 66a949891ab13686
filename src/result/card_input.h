// Reads card.json back: the quality of a finished collage, without its library.
#pragma once

#include <optional>
#include <string>

#include "core/base/stop.h"
#include "core/colour/seen_from_afar.h"
#include "core/quality/quality.h"

namespace tessera {

/// The measures that a card has, by its age. Each age has all measures of the ages before it.
enum class CardAge {
  first,    // none of the later measures
  picture,  // balance, dwarfs, copies, and the gaps between pieces
  variety,  // effective_shapes
};

struct ResultCard {
  std::string folder;  // of the result
  Quality quality;     // without the quantiles of the scales and the range of sizes
  CardAge age = CardAge::variety;
  std::optional<SeenFromAfar> afar;  // empty: no picture in pixels was compared with a colour.image
  double total_s = 0;
  StopReason stopped_by = StopReason::full;
};

/// Whether a signal, a time limit or a lost rank ended it, so that some of its pieces are still to come.
bool is_unfinished(const ResultCard& card);

/// Reads `folder`/card.json. Throws InputError that names file, key, what was found and what is allowed. Throws
/// EnvironmentError where the file is there and cannot be read.
ResultCard read_card(const std::string& folder);

/// The program that made the result in `folder`: "tessera 0.1.0, commit 0123456789ab". Empty where its card does not say.
std::string made_by(const std::string& folder);

}  // namespace tessera
