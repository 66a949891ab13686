// What deforming the pieces of a collage brought and cost, for the card.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "result/deformed_collage.h"

namespace tessera {

/// Section "deformation" of card.json (docs/result-format.md).
nlohmann::ordered_json deformation_json(const DeformationFigures& figures);

/// A section of card.txt, lines of less than 80 characters.
std::string deformation_text(const DeformationFigures& figures);

}  // namespace tessera
