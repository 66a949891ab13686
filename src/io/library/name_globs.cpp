#include "io/library/name_globs.h"

#include <fnmatch.h>

#include <algorithm>
#include <string>
#include <utility>

#include "io/nearest_name.h"
#include "io/utf8_text.h"

namespace tessera::io {
namespace {

constexpr std::size_t kNearNames = 5;
constexpr std::size_t kLongestCompared = 100;  // of a pattern; nobody mistypes a longer one by a letter

bool matches(const std::string& glob, const std::string& name, int flags = 0) {
  return ::fnmatch(glob.c_str(), name.c_str(), flags) == 0;
}

std::string letters_of(std::string glob) {
  std::erase_if(glob, [](char c) { return c == '*' || c == '?' || c == '[' || c == ']' || c == '\\'; });
  return glob;
}

/// How far a name is from what the pattern may have meant: its letters in another case, a part of the name, misspelt.
std::size_t distance(const std::string& glob, const std::string& letters, const std::string& name) {
  if (matches("*" + glob + "*", name, FNM_CASEFOLD)) return 0;
  return 1 + edit_distance(letters, name.substr(0, kLongestCompared));
}

std::string near_names(const std::string& glob, const std::vector<std::string>& names) {
  const std::string letters = letters_of(glob).substr(0, kLongestCompared);
  std::vector<std::pair<std::size_t, std::string>> near;
  for (const std::string& name : names) near.emplace_back(distance(glob, letters, name), name);
  std::sort(near.begin(), near.end());
  near.erase(std::unique(near.begin(), near.end()), near.end());  // mirror images have the names of their shapes
  const std::size_t shown = std::min(kNearNames, near.size());
  std::string text;
  for (std::size_t i = 0; i < shown; ++i) text += (i == 0 ? "" : ", ") + printable_utf8(near[i].second);
  return text;
}

}  // namespace

bool matches_any(const std::vector<std::string>& globs, const std::string& name) {
  return std::any_of(globs.begin(), globs.end(), [&](const std::string& glob) { return matches(glob, name); });
}

std::vector<bool> chosen_names(const std::vector<std::string>& names, const NameGlobs& globs,
                               const std::string& library) {
  for (const std::string& glob : globs.include) {
    if (std::any_of(names.begin(), names.end(), [&](const std::string& name) { return matches(glob, name); })) continue;
    throw NamesNotFound("include: no shape of " + library + " has a name like \"" + printable_utf8(glob) +
                        "\"; near it are: " + near_names(glob, names));
  }
  std::vector<bool> chosen(names.size());
  for (std::size_t i = 0; i < names.size(); ++i) {
    const bool included = globs.include.empty() || matches_any(globs.include, names[i]);
    chosen[i] = included && !matches_any(globs.exclude, names[i]);
  }
  if (std::find(chosen.begin(), chosen.end(), true) == chosen.end())
    throw NamesNotFound("exclude: nothing is left of the " + std::to_string(names.size()) + " shapes of " + library);
  return chosen;
}

}  // namespace tessera::io
