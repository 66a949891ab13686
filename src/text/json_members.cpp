#include "text/json_members.h"

#include <cstdint>
#include <nlohmann/json.hpp>

#include "core/base/error.h"
#include "text/utf8_text.h"

namespace tessera {

using nlohmann::json;

json member(const json& object, const char* key) { return object.is_object() ? object.value(key, json()) : json(); }

void refuse_member(const char* key, const json& found, const std::string& allowed) {
  constexpr std::size_t kShown_bytes = 60;
  const std::string text = found.is_null() ? "nothing" : found.dump(-1, ' ', true, json::error_handler_t::replace);
  throw InputError(std::string(key) + ": found " + cut_utf8(text, kShown_bytes) + ", allowed: " + allowed);
}

std::vector<int> numbers_member(const json& object, const char* key, int end, const std::string& allowed) {
  const json list = member(object, key);
  if (!list.is_array()) refuse_member(key, list, allowed);
  std::vector<int> numbers;
  for (const json& number : list) {
    if (!number.is_number_unsigned() || number.get<std::uint64_t>() >= std::uint64_t(end)) {
      refuse_member(key, number, allowed);
    }
    numbers.push_back(number.get<int>());
  }
  return numbers;
}

}  // namespace tessera
