// Adds the results of drawing to the cards of a result, each time it is drawn.
#pragma once

#include <string>
#include <vector>

#include "result/drawing_notes.h"

namespace tessera {

/// Writes section "drawing" of card.json and section Drawing of card.txt, in place of those of an earlier drawing. Writes
/// "from_afar" before them where the notes have it; otherwise that of the last picture in pixels stays. Returns, one in a
/// line, why a card stays as it is: it is missing or not ours. Throws EnvironmentError where a card is there and cannot be
/// read or written.
std::vector<std::string> add_drawing_to_cards(const std::string& dir, const DrawingNotes& notes);

}  // namespace tessera
