// Members of foreign JSON objects, with errors that name the key, what was found and what is allowed.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

namespace tessera {

/// The member, or null where there is none or `object` is no object.
nlohmann::json member(const nlohmann::json& object, const char* key);

/// Throws InputError.
[[noreturn]] void refuse_member(const char* key, const nlohmann::json& found, const std::string& allowed);

/// The member as a list of whole numbers from 0 to `end` - 1. Throws InputError; `allowed` is a part of its message.
std::vector<int> numbers_member(const nlohmann::json& object, const char* key, int end, const std::string& allowed);

}  // namespace tessera
