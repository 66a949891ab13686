// The cards of all results that a command was given.
#pragma once

#include <string>
#include <vector>

#include "result/card_input.h"

namespace tessera {

/// `arguments`: results, or folders of results. A warning names each result that is left out, because it is not whole or
/// has no card. Throws InputError where there is none, EnvironmentError where a folder cannot be read.
std::vector<ResultCard> found_cards(const std::vector<std::string>& arguments);

}  // namespace tessera
