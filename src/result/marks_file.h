// The file in which the page of a result (tessera report) saves the pieces that its reader marked.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "result/placed_pieces.h"
#include "text/json_bounds.h"

namespace tessera {

/// Numbers of pieces, `index` of pieces.geojson.
struct Marks {
  bool swaps = false;            // other drawings shall replace the pieces
  std::vector<int> pieces = {};  // to remove
  std::vector<int> locked = {};
};

/// Of a file of marks, and of other JSON with lists of pieces.
inline constexpr JsonBounds kMarksBounds{.values = 2 * kMostPieces + 100, .levels = 4, .members = 100};

/// Reads the file; docs/result-format.md ("Marks") has its keys. `pieces_digest`: ResultManifest::pieces_digest of the
/// result that it must belong to. Throws InputError that names the file, the key, what was found and what is allowed.
Marks read_marks(const std::string& path, const std::string& pieces_digest);

/// The text of such a file.
std::string marks_text(const Marks& marks, const std::string& pieces_digest);

/// The members `pieces` and `lock`. Throws InputError that names the key.
Marks listed_marks(const nlohmann::json& object, bool swaps);

}  // namespace tessera
