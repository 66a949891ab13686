#include "job/palette.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdint>
#include <filesystem>
#include <map>
#include <sstream>

#include "artwork/images/colour_conversion.h"
#include "core/base/error.h"
#include "core/base/split_text.h"
#include "files/regular_file.h"
#include "job/job_entry.h"
#include "text/nearest_name.h"
#include "text/text_encoding.h"

namespace tessera {
namespace {

constexpr std::size_t kMostPaletteBytes = 64 << 10;
constexpr std::size_t kMostColours = 256;

/// Made for the default background, a warm white: each colour contrasts with it and with the others.
const std::map<std::string, std::vector<std::string>>& built_in() {
  static const std::map<std::string, std::vector<std::string>> palettes = {
      {"dusk", {"#264653", "#2a9d8f", "#e9a83b", "#ef7f45", "#c8443d", "#7b4b73", "#5b8fb9"}},
      {"forest", {"#1f3a34", "#3f6b4f", "#7f9f5f", "#b9a44c", "#b5652b", "#7a3b2e", "#4d6a78"}},
      {"ink", {"#0f2740", "#1f4e79", "#3a7ca5", "#7fa8c9", "#5f6f8c", "#2f4858"}},
  };
  return palettes;
}

bool is_colour(const std::string& text) {
  return text.size() == 7 && text[0] == '#' &&
         std::all_of(text.begin() + 1, text.end(), [](unsigned char c) { return std::isxdigit(c); });
}

std::string in_lower_case(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return char(std::tolower(c)); });
  return text;
}

/// The colour in a line of a GIMP palette, "38 70 83 name"; empty where the line is none.
std::string gimp_colour(const std::string& line) {
  std::istringstream words(line);
  std::array<int, 3> rgb{};
  for (int& value : rgb) {
    if (!(words >> value) || value < 0 || value > 255) return {};
  }
  const auto byte = [&](std::size_t channel) { return std::uint8_t(rgb[channel]); };
  return hex_of({byte(2), byte(1), byte(0)});
}

bool is_gimp_header(const std::string& line) {
  return line.empty() || line[0] == '#' || line.starts_with("Name:") || line.starts_with("Columns:");
}

[[noreturn]] void refuse_colour(const std::string& where, const std::string& found, const char* allowed) {
  throw InputError(where + ": found \"" + printable(found) + "\", allowed: " + allowed);
}

/// The colours of a palette file, read line by line.
std::vector<std::string> colours_in(const std::string& text, const std::string& path) {
  std::istringstream lines(text);
  std::vector<std::string> colours;
  bool gimp = false;
  std::string line;
  for (int number = 1; std::getline(lines, line); ++number) {
    line = std::string(trimmed(line));
    const std::string where = path + ":" + std::to_string(number);
    if (number == 1 && line == "GIMP Palette") {
      gimp = true;
    } else if (gimp) {
      if (is_gimp_header(line)) continue;
      colours.push_back(gimp_colour(line));
      if (colours.back().empty()) refuse_colour(where, line, "red, green, blue from 0 to 255, and a name");
    } else if (!line.empty()) {
      if (!is_colour(line)) refuse_colour(where, line, "#rrggbb");
      colours.push_back(in_lower_case(line));
    }
  }
  return colours;
}

/// The colours without repetition.
std::vector<std::string> distinct(const std::vector<std::string>& colours) {
  std::vector<std::string> result;
  for (const std::string& colour : colours) {
    if (std::find(result.begin(), result.end(), colour) == result.end()) result.push_back(colour);
  }
  return result;
}

std::vector<std::string> colours_of_file(const std::string& path) {
  const std::string text = utf8_text(read_regular_file(path, kMostPaletteBytes), path);
  const std::vector<std::string> colours = distinct(colours_in(text, path));
  if (colours.empty()) throw InputError(path + ": no colours in it");
  if (colours.size() > kMostColours) {
    throw InputError(path + ": " + std::to_string(colours.size()) +
                     " colours, allowed: " + std::to_string(kMostColours));
  }
  return colours;
}

/// `place` begins the messages: the key or option that asks for the palette.
std::vector<std::string> load(const std::string& place, const std::vector<std::string>& palette) {
  if (is_colour_list(palette)) return distinct(palette);
  if (const auto found = built_in().find(palette[0]); found != built_in().end()) return found->second;
  try {
    return colours_of_file(palette[0]);
  } catch (const InputError& error) {
    std::string names;
    for (const std::string& name : built_in_palettes()) names += name + ", ";
    const std::string nearest = nearest_name(std::filesystem::path(palette[0]).filename(), built_in_palettes());
    throw InputError(place + ": " + error.what() + (nearest.empty() ? "" : " (did you mean " + nearest + "?)") +
                     "; allowed: " + names + "a GIMP palette or a file with a #rrggbb a line, or a list of colours");
  }
}

}  // namespace

const std::vector<std::string>& built_in_palettes() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> all;
    for (const auto& [name, colours] : built_in()) all.push_back(name);
    return all;
  }();
  return names;
}

bool is_colour_list(const std::vector<std::string>& palette) { return palette.size() > 1 || is_colour(palette[0]); }

std::vector<std::string> load_palette(const Job& job, const std::string& option) {
  return load(option.empty() ? job.path + ": colour.palette" : option, job.colour.palette);
}

std::vector<std::string> load_library_colours(const Job& job) {
  if (job.library_colours == std::vector<std::string>{"all"}) return {};
  return load(job.path + ": library.colours", job.library_colours);
}

}  // namespace tessera
