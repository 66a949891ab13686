#include "library/name_globs.h"

#include <fnmatch.h>

#include <algorithm>
#include <functional>
#include <iterator>
#include <numeric>
#include <string>
#include <utility>

#include "core/base/count_text.h"
#include "text/utf8_text.h"

namespace tessera {
namespace {

constexpr std::size_t kNearNames = 5;
constexpr std::size_t kLongestCompared = 100;  // of a pattern; a longer one is hardly mistyped by single letters

/// The parts of a pattern: a letter, any letter, or any number of letters.
constexpr int kAnyLetter = -1, kAnyLetters = -2;

std::vector<int> parts_of(const std::string& glob) {
  std::vector<int> parts;
  for (std::size_t at = 0; at < glob.size(); ++at) {
    const std::size_t close = glob[at] == '[' ? glob.find(']', at) : glob.npos;
    if (glob[at] == '*') {
      parts.push_back(kAnyLetters);
    } else if (glob[at] == '?' || close != glob.npos) {
      parts.push_back(kAnyLetter);
    } else if (glob[at] != '\\') {
      parts.push_back(static_cast<unsigned char>(glob[at]));
    }
    if (close != glob.npos) at = close;
  }
  return parts;
}

/// The number of letters in the name that are missing, superfluous or different from the pattern.
std::size_t mistakes(const std::vector<int>& parts, const std::string& name) {
  std::vector<std::size_t> row(name.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t(0));
  for (const int part : parts) {
    const std::size_t extra = part == kAnyLetters ? 0 : 1;
    std::size_t diagonal = std::exchange(row[0], row[0] + extra);
    for (std::size_t j = 1; j <= name.size(); ++j) {
      const bool fits = part < 0 || part == static_cast<unsigned char>(name[j - 1]);
      const std::size_t fitted = diagonal + (fits ? 0 : 1);
      diagonal = row[j];
      row[j] = std::min({fitted, row[j] + extra, row[j - 1] + extra});
    }
  }
  return row.back();
}

/// The distance of a name from what the pattern may have meant: 0 where the letters differ only in case or the pattern is a part
/// of the name.
std::size_t distance(const std::string& glob, const std::vector<int>& parts, const std::string& name) {
  if (::fnmatch(("*" + glob + "*").c_str(), name.c_str(), FNM_CASEFOLD) == 0) return 0;
  return 1 + mistakes(parts, name.substr(0, kLongestCompared));
}

std::string near_names(const std::string& glob, const std::vector<std::string>& names) {
  const std::vector<int> parts = parts_of(glob.substr(0, kLongestCompared));
  std::vector<std::pair<std::size_t, std::string>> near;
  for (const std::string& name : names) near.emplace_back(distance(glob, parts, name), name);
  std::sort(near.begin(), near.end());
  near.erase(std::unique(near.begin(), near.end()), near.end());  // mirror images have the names of their shapes
  const std::size_t shown = std::min(kNearNames, near.size());
  std::string text;
  for (std::size_t i = 0; i < shown; ++i) text += (i == 0 ? "" : ", ") + printable_utf8(near[i].second);
  return text;
}

using Places = std::vector<std::uint32_t>;

Places all_places(const NameIndex& names) {
  Places places(names.names().size());
  std::iota(places.begin(), places.end(), 0u);
  return places;
}

/// The places of matching names, ascending, each once. Calls `missing` for patterns that match no name.
Places places_of(const std::vector<std::string>& globs, const NameIndex& names,
                 const std::function<void(const std::string& glob)>& missing) {
  Places places;
  for (const std::string& glob : globs) {
    const Places more = names.matching(glob);
    if (more.empty()) missing(glob);
    places.insert(places.end(), more.begin(), more.end());
  }
  std::sort(places.begin(), places.end());
  places.erase(std::unique(places.begin(), places.end()), places.end());
  return places;
}

}  // namespace

std::vector<std::uint32_t> chosen_names(const NameIndex& names, const NameGlobs& globs, const std::string& library) {
  const auto fail = [&](const std::string& glob) {
    throw NamesNotFound("include", "no shape of " + library + " has a name like \"" + printable_utf8(glob) +
                                       "\"; near it are: " + near_names(glob, names.names()));
  };
  const Places included = globs.include.empty() ? all_places(names) : places_of(globs.include, names, fail);
  const Places excluded = places_of(globs.exclude, names, [](const std::string&) {});
  Places chosen;
  std::set_difference(included.begin(), included.end(), excluded.begin(), excluded.end(), std::back_inserter(chosen));
  if (chosen.empty()) {
    throw NamesNotFound("exclude",
                        "nothing is left of the " + count_text(names.names().size(), "shape") + " of " + library);
  }
  return chosen;
}

}  // namespace tessera
