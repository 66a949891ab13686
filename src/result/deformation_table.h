// The part of the card about deformed pieces: what deforming them gained and cost.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "result/deformed_collage.h"

namespace tessera {

/// Section "deformation" of card.json (docs/result-format.md).
nlohmann::ordered_json deformation_json(const DeformationFigures& figures);

/// The section of card.txt. Lines have less than 80 characters.
std::string deformation_text(const DeformationFigures& figures);

}  // namespace tessera
