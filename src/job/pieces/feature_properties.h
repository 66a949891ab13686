// Reads the properties of the features of a GeoJSON file, one feature after the other. Polygons and all other parts of
// the file take no memory.
#pragma once

#include <functional>
#include <nlohmann/json.hpp>
#include <string_view>
#include <vector>

#include "text/json_file.h"

namespace tessera {

/// Calls take(feature) for each feature: an object whose "properties" have no members except `keys`. An element that is
/// no object is passed as it is. Throws InputError that names the feature's number, also for errors of `take`, and
/// where there are more than `most` features. Throws nlohmann's exceptions where the file is no JSON.
void read_feature_properties(JsonFile& file, const std::vector<std::string_view>& keys, std::size_t most,
                             const std::function<void(const nlohmann::json& feature)>& take);

}  // namespace tessera
