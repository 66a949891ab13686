// What a benchmark hands back: a text for people, and the same figures as JSON.
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

/// Three significant digits: "2.16e+09", "0.0642".
std::string short_number(double value);

/// The value with three decimals, as the files of a collage have them.
double rounded(double value);

/// The folder of `path` must be there. Throws EnvironmentError.
void write_report(const Report& report, const std::string& path);

}  // namespace tessera::bench
