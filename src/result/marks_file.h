// The file in which the page of a result (tessera report) saves the pieces that its reader marked.
#pragma once

#include <string>
#include <vector>

namespace tessera {

/// Numbers of pieces, `index` of pieces.geojson.
struct Marks {
  bool swaps = false;       // other drawings shall replace the pieces
  std::vector<int> pieces;  // to remove
  std::vector<int> locked;
};

/// Reads the file; docs/result-format.md ("Marks") has its keys. `pieces_digest`: ResultManifest::pieces_digest of the
/// result that it must belong to. Throws InputError that names the file, the key, what was found and what is allowed.
Marks read_marks(const std::string& path, const std::string& pieces_digest);

}  // namespace tessera
