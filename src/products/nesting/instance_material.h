// Reads the material of an instance: a strip, or a bin, which is a sheet. Other materials of jagua-rs are refused by name.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "products/nesting/nest_input.h"

namespace tessera {

/// Reads strip_height and bins: one kind of bin, a rectangle without zones. Throws InputError that names and explains the
/// key where the instance has several kinds of bins, bins of another shape, zones, or the keys of the older format.
void read_material(const nlohmann::json& instance, const std::string& path, NestInput& input);

/// Throws InputError where an item asks for a quality of the material.
void check_quality(const nlohmann::json& item, const std::string& where);

}  // namespace tessera
