// How long drawing took, and which pieces of a picture are not drawn from their originals, for the card and for stderr.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "artwork/protocol/drawer_layers.h"
#include "result/afar_section.h"

namespace tessera {

enum class DrawnFrom { thumbnail, silhouette };

/// A shape's pieces.
struct DrawingNote {
  std::string shape;  // its name
  DrawnFrom from = DrawnFrom::thumbnail;
  std::string reason;
  std::size_t pieces = 0;
};

struct DrawingNotes {
  std::size_t pieces = 0;               // of the collage
  std::vector<DrawingNote> notes = {};  // in the order of the library
  double seconds = 0;                   // that drawing took, reading the result included
  std::optional<AfarNote> afar = {};    // of a picture in pixels, where colour.image is shown
  std::vector<std::string> cards = {};  // why a card does not tell of this drawing
  DrawerLayers layers = {};             // not for the card: it tells of the result, whatever the machine
};

/// The card's section "drawing" (docs/result-format.md), as JSON.
std::string drawing_json(const DrawingNotes& notes);

/// The first line of drawing_text().
inline constexpr const char* kDrawingHeading = "Drawing\n";

/// A section of card.txt, lines of less than 80 characters.
std::string drawing_text(const DrawingNotes& notes);

/// One line that counts the pieces by reason and names the cards that do not tell of them; mostly empty.
std::string drawing_warning(const DrawingNotes& notes);

}  // namespace tessera
