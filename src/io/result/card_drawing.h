// What drawing adds to the cards of a result, each time anew.
#pragma once

#include <string>

#include "io/result/drawing_notes.h"

namespace tessera::io {

/// Writes section "drawing" of card.json and section Drawing of card.txt, in place of those of an earlier drawing.
/// Throws InputError where there are no cards, EnvironmentError where they cannot be written.
void add_drawing_to_cards(const std::string& dir, const DrawingNotes& notes);

}  // namespace tessera::io
