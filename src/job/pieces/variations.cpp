#include "job/pieces/variations.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cstdint>
#include <optional>
#include <set>

#include "core/base/error.h"
#include "core/base/split_text.h"
#include "job/job_entry.h"

namespace tessera {
namespace {

struct Axis {
  std::string key;
  std::vector<std::string> values;
  bool in_name;  // whether the value is part of each variation's name
};

/// Splits at commas outside brackets and quotes.
std::vector<std::string> split(const std::string& text) {
  const std::vector<std::string_view> parts = split_outside(text, ',');
  return {parts.begin(), parts.end()};
}

std::optional<std::uint64_t> whole_number(const std::string& text) {
  std::uint64_t value = 0;
  const auto end = std::from_chars(text.data(), text.data() + text.size(), value);
  if (text.empty() || end.ec != std::errc() || end.ptr != text.data() + text.size()) return std::nullopt;
  return value;
}

/// "3" or "3-7". Even a single seed is part of the names: a campaign with more seeds then finds its result.
Axis seed_axis(const std::string& seeds) {
  Axis axis{"seed", {}, true};
  for (const std::string& part : split(seeds)) {
    const auto dash = part.find('-');
    const auto first = whole_number(part.substr(0, dash));
    const auto last = dash == std::string::npos ? first : whole_number(part.substr(dash + 1));
    if (!first || !last || *first > *last || *last - *first >= kMaxVariations) {
      throw InputError("--seeds " + printable(seeds) + ": found \"" + printable(part) +
                       "\", allowed: seeds and ranges of at most " + std::to_string(kMaxVariations) +
                       " like 7 or 1-8,12");
    }
    for (std::uint64_t seed = *first; seed <= *last; ++seed) axis.values.push_back(std::to_string(seed));
  }
  return axis;
}

Axis set_axis(const std::string& text) {
  const auto equals = text.find('=');
  if (equals == std::string::npos || equals == 0) {
    throw InputError("--set " + printable(text) + ": allowed: section.key=value or section.key=value,value,...");
  }
  Axis axis{text.substr(0, equals), split(text.substr(equals + 1)), false};
  axis.in_name = axis.values.size() > 1;
  for (const std::string& value : axis.values) {
    if (value.empty() && axis.values.size() > 1) {
      throw InputError("--set " + printable(text) + ": found an empty value, allowed: section.key=value,value,...");
    }
  }
  return axis;
}

void check_varied(const std::vector<Axis>& axes) {
  if (std::any_of(axes.begin(), axes.end(), [](const Axis& axis) { return axis.in_name; })) return;
  throw InputError(
      "campaign: nothing varies; allowed: --seeds 1-8 or a single seed, --set section.key=value,value,...");
}

void check_distinct(const std::vector<Axis>& axes) {
  std::set<std::string> keys;
  for (const Axis& axis : axes) {
    if (!keys.insert(axis.key).second) {
      throw InputError("campaign: " + printable(axis.key) + " is given twice; allowed: each key once");
    }
    std::set<std::string> values;
    for (const std::string& value : axis.values) {
      if (!values.insert(value).second) {
        throw InputError("campaign: " + printable(axis.key) + ": found " + printable(value) +
                         " twice, allowed: each value once");
      }
    }
  }
}

std::size_t checked_count(const std::vector<Axis>& axes) {
  std::size_t count = 1;
  for (const Axis& axis : axes) {
    count *= axis.values.size();
    if (count > kMaxVariations) {
      throw InputError("campaign: more than " + std::to_string(kMaxVariations) + " variations, the most allowed");
    }
  }
  return count;
}

/// "objective.gap_weight" and "0.5" become "gap_weight_0.5".
std::string name_part(const Axis& axis, const std::string& value) {
  std::string text = axis.key.substr(axis.key.find('.') + 1) + "_" + value;
  for (char& c : text) {
    if (!std::isalnum(static_cast<unsigned char>(c)) && c != '.') c = '_';
  }
  return text;
}

/// Numbers names that would be equal: values may differ only in characters that a folder name should not have.
std::string unique(const std::string& name, std::set<std::string>& taken) {
  constexpr std::size_t kMaxName = 120;
  const std::string stem = name.substr(0, kMaxName);
  std::string candidate = stem;
  for (int k = 2; !taken.insert(candidate).second; ++k) candidate = stem + "-" + std::to_string(k);
  return candidate;
}

Variation variation(const std::vector<Axis>& axes, std::size_t index, std::size_t count) {
  Variation result;
  for (const Axis& axis : axes) {
    count /= axis.values.size();
    const std::string& value = axis.values[index / count % axis.values.size()];
    result.overrides.push_back(axis.key + "=" + value);
    if (axis.in_name) result.name += (result.name.empty() ? "" : "-") + name_part(axis, value);
  }
  return result;
}

}  // namespace

std::vector<Variation> make_variations(const std::string& seeds, const std::vector<std::string>& sets) {
  std::vector<Axis> axes;
  if (!seeds.empty()) axes.push_back(seed_axis(seeds));
  for (const std::string& text : sets) axes.push_back(set_axis(text));
  check_varied(axes);
  check_distinct(axes);
  const std::size_t count = checked_count(axes);
  std::vector<Variation> variations;
  std::set<std::string> taken;
  for (std::size_t i = 0; i < count; ++i) {
    variations.push_back(variation(axes, i, count));
    variations.back().name = unique(variations.back().name, taken);
  }
  return variations;
}

}  // namespace tessera
