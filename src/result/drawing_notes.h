// Notes about drawing, for the card and for stderr: how long it took, and which pieces are not drawn from their originals.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "artwork/protocol/drawer_layers.h"
#include "result/afar_section.h"

namespace tessera {

enum class DrawnFrom { thumbnail, silhouette };

/// A note about all pieces of one shape.
struct DrawingNote {
  std::string shape;  // its name
  DrawnFrom from = DrawnFrom::thumbnail;
  std::string reason;
  std::size_t pieces = 0;
};

struct DrawingNotes {
  std::size_t pieces = 0;               // of the collage
  std::vector<DrawingNote> notes = {};  // in the order of the library
  double seconds = 0;                   // time of drawing, including reading the result
  std::optional<AfarNote> afar = {};    // of a picture in pixels, where it shows colour.image
  std::vector<std::string> cards = {};  // why cards do not tell of this drawing
  DrawerLayers layers = {};             // not in the card, because they depend on the machine
};

/// The section "drawing" of the card (docs/result-format.md), as JSON.
std::string drawing_json(const DrawingNotes& notes);

/// The first line of drawing_text().
inline constexpr const char* kDrawingHeading = "Drawing\n";

/// The section of card.txt. Lines have less than 80 characters.
std::string drawing_text(const DrawingNotes& notes);

/// One line that counts pieces by reason and names the cards that do not tell of them; mostly empty.
std::string drawing_warning(const DrawingNotes& notes);

}  // namespace tessera
