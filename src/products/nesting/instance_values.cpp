#include "products/nesting/instance_values.h"

#include <cmath>

#include "core/base/error.h"
#include "products/nesting/drawings/nest_contours.h"
#include "text/utf8_text.h"

namespace tessera {

using nlohmann::json;

std::string shown_value(const json& value) {
  if (value.is_structured()) return value.is_array() ? "a list" : "an object";
  return cut_utf8(printable_utf8(value.dump(-1, ' ', true, json::error_handler_t::replace)), 40);
}

const json& member(const json& object, const char* key, const std::string& where) {
  const auto at = object.is_object() ? object.find(key) : object.end();
  if (!object.is_object() || at == object.end()) throw InputError(where + ": has no \"" + key + "\"");
  return *at;
}

double number_in(const json& value, double least, double most, const std::string& where) {
  if (value.is_number()) {
    const double number = value.get<double>();
    if (number >= least && number <= most) return number;
  }
  const std::string allowed = json(least).dump() + " to " + json(most).dump();
  throw InputError(where + ": found " + shown_value(value) + ", allowed: a number from " + allowed);
}

int whole_number_in(const json& value, int least, int most, const std::string& where) {
  if (value.is_number()) {
    const double number = value.get<double>();
    if (number >= least && number <= most && number == std::floor(number)) return int(number);
  }
  throw InputError(where + ": found " + shown_value(value) + ", allowed: a whole number from " + std::to_string(least) +
                   " to " + std::to_string(most));
}

const json* optional_member(const json& object, const char* key) {
  const auto at = object.is_object() ? object.find(key) : object.end();
  return !object.is_object() || at == object.end() || at->is_null() ? nullptr : &*at;
}

InstanceRectangle rectangle_of(const json& data, const std::string& where) {
  const auto of = [&](const char* key, double least) {
    return number_in(member(data, key, where), least, kFarthest_mm, where + ": " + key);
  };
  const auto corner = [&](const char* key) { return data.contains(key) ? of(key, -kFarthest_mm) : 0.0; };
  return {corner("x_min"), corner("y_min"), of("width", 1e-6), of("height", 1e-6)};
}

}  // namespace tessera
