#include "library/name_index.h"

#include <fnmatch.h>

#include <algorithm>
#include <functional>
#include <iterator>
#include <numeric>
#include <string_view>
#include <utility>

#include "text/utf8_text.h"

namespace tessera {
namespace {

constexpr const char* kWildCards = "*?[\\";

}  // namespace

bool is_pattern(const std::string& glob) { return glob.find_first_of(kWildCards) != std::string::npos; }

NameIndex::NameIndex(std::vector<std::string> names, const std::vector<std::string>& other_names)
    : names_(std::move(names)),
      in_order_(names_.size()) {
  std::ranges::copy_if(other_names, std::inserter(other_names_, other_names_.end()), is_pattern);
  for (std::uint32_t place = 0; place < names_.size(); ++place) {
    std::string shown = printable_utf8(names_[place]);
    if (shown != names_[place]) shown_[std::move(shown)].push_back(place);
  }
  std::iota(in_order_.begin(), in_order_.end(), 0u);
  std::stable_sort(in_order_.begin(), in_order_.end(),
                   [&](std::uint32_t a, std::uint32_t b) { return names_[a] < names_[b]; });
}

std::span<const std::uint32_t> NameIndex::named(const std::string& name) const {
  const auto found = std::ranges::equal_range(in_order_, std::string_view(name), std::less<std::string_view>(),
                                              [&](std::uint32_t place) { return std::string_view(names_[place]); });
  return {found.begin(), found.end()};
}

std::span<const std::uint32_t> NameIndex::candidates(const std::string& glob) const {
  const std::size_t start = glob.find_first_of(kWildCards);
  const std::span<const std::uint32_t> exact = named(glob);
  if (!exact.empty() || start == std::string::npos || other_names_.contains(glob)) return exact;
  const auto beginning = [&](std::uint32_t place) { return std::string_view(names_[place]).substr(0, start); };
  const auto found = std::ranges::equal_range(in_order_, std::string_view(glob).substr(0, start),
                                              std::less<std::string_view>(), beginning);
  return {found.begin(), found.end()};
}

std::optional<std::uint32_t> NameIndex::find(const std::string& name) const {
  if (const std::span<const std::uint32_t> places = named(name); !places.empty()) return places.front();
  const auto shown = shown_.find(name);
  return shown == shown_.end() ? std::nullopt : std::optional(shown->second.front());
}

std::vector<std::uint32_t> NameIndex::matching(const std::string& glob) const {
  if (const auto shown = shown_.find(glob); shown != shown_.end() && named(glob).empty()) return shown->second;
  std::vector<std::uint32_t> places;
  for (const std::uint32_t place : candidates(glob)) {
    if (names_[place] == glob || ::fnmatch(glob.c_str(), names_[place].c_str(), 0) == 0) places.push_back(place);
  }
  std::sort(places.begin(), places.end());
  return places;
}

}  // namespace tessera
