// What drawing adds to the cards of a result, each time anew.
#pragma once

#include <string>
#include <vector>

#include "result/drawing_notes.h"

namespace tessera {

/// Writes section "drawing" of card.json and section Drawing of card.txt, in place of those of an earlier drawing;
/// before them "from_afar", where the notes have it: else that of the last picture in pixels stays. Returns why a card
/// that is missing or not ours stays as it is, a line each. Throws EnvironmentError where one is there and cannot be
/// read or written.
std::vector<std::string> add_drawing_to_cards(const std::string& dir, const DrawingNotes& notes);

}  // namespace tessera
