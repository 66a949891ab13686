// card.json read back: what a finished collage is like, without its library.
#pragma once

#include <optional>
#include <string>

#include "core/base/stop.h"
#include "core/colour/seen_from_afar.h"
#include "core/quality/quality.h"

namespace tessera {

/// What a card tells of, by when it was made; each tells all that earlier ones do.
enum class CardAge {
  first,    // nothing of these
  picture,  // balance, dwarfs, copies, and the gaps between pieces
  variety,  // effective_shapes
};

struct ResultCard {
  std::string folder;  // of the result
  Quality quality;     // but for the quantiles of the scales, and the range of sizes
  CardAge age = CardAge::variety;
  std::optional<SeenFromAfar> afar;  // without it no picture in pixels was measured against a colour.image
  double total_s = 0;
  StopReason stopped_by = StopReason::full;
};

/// Whether a signal, a time limit or a lost rank ended it: its pieces are not all that there will be.
bool is_unfinished(const ResultCard& card);

/// Reads `folder`/card.json. Throws InputError that names file, key, what was found and what is
/// allowed, and EnvironmentError where it is there and cannot be read.
ResultCard read_card(const std::string& folder);

/// The program that made the result in `folder`, "tessera 0.1.0, commit 0123456789ab"; empty where its card does not
/// say.
std::string made_by(const std::string& folder);

}  // namespace tessera
