// The properties of the features of a GeoJSON file, one feature after the other: polygons, and whatever else the file
// holds, take no memory.
#pragma once

#include <functional>
#include <nlohmann/json.hpp>
#include <string_view>
#include <vector>

#include "text/json_file.h"

namespace tessera {

/// Calls take(feature) for each feature, an object whose "properties" have no other members than `keys`; what is no
/// feature is handed out as it is. Throws InputError that names the feature by its number, also of what `take` throws,
/// and where there are more features than `most`; nlohmann's exceptions where the file is no JSON.
void read_feature_properties(JsonFile& file, const std::vector<std::string_view>& keys, std::size_t most,
                             const std::function<void(const nlohmann::json& feature)>& take);

}  // namespace tessera
