// A campaign: one job with several values for some of its keys.
#pragma once

#include <string>
#include <vector>

namespace tessera {

/// Most variations; more would be a mistyped range.
inline constexpr std::size_t kMaxVariations = 10000;

struct Variation {
  std::string name;                    // unique and usable as folder name: "seed_3-gap_weight_0.5"
  std::vector<std::string> overrides;  // as load_job takes them
};

/// Every combination of seeds and values; the last key changes fastest. `seeds`: "1-8,12", or empty for the job's seed.
/// `sets`: "section.key=value,value"; commas in brackets and quotes are part of a value. A key with a single value is
/// not part of the names; a seed always is. Throws InputError that names the argument, what was found and what is
/// allowed. load_job checks whether the job takes the values.
std::vector<Variation> make_variations(const std::string& seeds, const std::vector<std::string>& sets);

}  // namespace tessera
