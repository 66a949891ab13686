// A campaign: one job with several values of some of its keys.
#pragma once

#include <string>
#include <vector>

namespace tessera {

/// More would be a mistyped range.
inline constexpr std::size_t kMaxVariations = 10000;

struct Variation {
  std::string name;                    // "seed_3-gap_weight_0.5", fit for a folder; unique
  std::vector<std::string> overrides;  // as load_job takes them
};

/// Every seed with every combination of values, the last key running fastest. `seeds`: "1-8,12" or empty for that of
/// the job. `sets`: "section.key=value,value"; commas in brackets and quotes belong to a value; a single value of a key
/// is the same in all variations and not part of their names, but a single seed is. Throws InputError that names the
/// argument, what was found and what is allowed; whether the job takes the values is for load_job to say.
std::vector<Variation> make_variations(const std::string& seeds, const std::vector<std::string>& sets);

}  // namespace tessera
