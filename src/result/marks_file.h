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
  enum class Action { erase, swap, relax };  // relax: all pieces that are not locked
  Action action = Action::erase;
  std::vector<int> pieces = {};  // to erase or to swap
  std::vector<int> locked = {};
};

/// The limits of a file of marks, and of other JSON with lists of pieces.
inline constexpr JsonBounds kMarksBounds{.values = 2 * kMostPieces + 100, .levels = 4, .members = 100};

/// Reads the file; docs/result-format.md ("Marks") has its keys. `pieces_digest`: ResultManifest::pieces_digest of the
/// result that it must belong to. Throws InputError that names the file, the key, what was found and what is allowed.
Marks read_marks(const std::string& path, const std::string& pieces_digest);

/// The text of such a file.
std::string marks_text(const Marks& marks, const std::string& pieces_digest);

/// The members `action`, `pieces` and `lock` of an object. Throws InputError that names the key.
Marks marks_in(const nlohmann::json& object);

}  // namespace tessera
