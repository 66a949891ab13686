// Reads properties of the pieces in a result's pieces.geojson.
#pragma once

#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace tessera {

/// Calls take(properties) for each piece, in order of placement; `properties` has no members but `keys`. Throws InputError
/// that names the file and what is wrong with it, also where `take` throws nlohmann's exceptions.
void read_piece_properties(const std::string& dir, const std::vector<std::string_view>& keys,
                           const std::function<void(const nlohmann::json& properties)>& take);

}  // namespace tessera
