// The result of a benchmark: a text for people, and the same figures as JSON.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace tessera::bench {

using Json = nlohmann::ordered_json;

struct Report {
  std::string text;
  Json json;
};

/// The value with three significant digits: "2.16e+09", "0.0642".
std::string short_number(double value);

/// The value with three decimals, as in the files of a collage.
double rounded(double value);

/// Writes the JSON. The folder of `path` must exist. Throws EnvironmentError.
void write_report(const Report& report, const std::string& path);

}  // namespace tessera::bench
