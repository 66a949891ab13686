// Reads and checks values of an instance's JSON; `where` names the value in messages.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace tessera {

/// The value for messages. A list or an object, however deep, is shown by its kind only.
std::string shown_value(const nlohmann::json& value);

/// The value of the key. Throws InputError where `object` has no such key.
const nlohmann::json& member(const nlohmann::json& object, const char* key, const std::string& where);

/// The value of the key; null where there is none, or JSON's null.
const nlohmann::json* optional_member(const nlohmann::json& object, const char* key);

/// Throws InputError where the value is no number from `least` to `most`.
double number_in(const nlohmann::json& value, double least, double most, const std::string& where);
int whole_number_in(const nlohmann::json& value, int least, int most, const std::string& where);

/// x_min, y_min, width and height of a shape of the type "rectangle".
struct InstanceRectangle {
  double x = 0, y = 0, width = 0, height = 0;
};

/// Reads a rectangle. `data`: of the shape. Throws InputError.
InstanceRectangle rectangle_of(const nlohmann::json& data, const std::string& where);

}  // namespace tessera
