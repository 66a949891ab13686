#include "bench/blocking/twins.h"

#include <map>
#include <sstream>

#include "core/base/error.h"
#include "files/regular_file.h"

namespace tessera::bench {
namespace {

constexpr std::size_t kMostTwinBytes = std::size_t(16) << 20;

/// Removes the mark of a mirror image, and returns whether there was one.
bool take_tilde(std::string& name) {
  if (!name.starts_with('~')) return false;
  name.erase(0, 1);
  return true;
}

}  // namespace

Twins::Twins(const std::string& text, const std::string& path, const std::vector<Silhouette>& silhouettes) {
  std::map<std::string, std::size_t> by_name;
  for (std::size_t i = 0; i < silhouettes.size(); ++i) by_name[silhouettes[i].name] = i;
  std::istringstream lines(text);
  std::string line;
  for (int number = 1; std::getline(lines, line); ++number) {
    std::istringstream words(line.substr(0, line.find('#')));
    std::string a, b;
    if (!(words >> a)) continue;
    if (!(words >> b)) {
      throw InputError(path + ", line " + std::to_string(number) + ": found one name, \"" + a +
                       "\"; needed: two names, which are twins");
    }
    const bool mirrored = take_tilde(a) != take_tilde(b);
    const auto at_a = by_name.find(a), at_b = by_name.find(b);
    if (at_a == by_name.end() || at_b == by_name.end() || (at_a == at_b && !mirrored)) continue;
    pairs_.insert({std::min(at_a->second, at_b->second), std::max(at_a->second, at_b->second), mirrored});
  }
}

Twins read_twins(const std::string& path, const std::vector<Silhouette>& silhouettes) {
  const std::vector<std::uint8_t> bytes = read_regular_file(path, kMostTwinBytes);
  return Twins(std::string(bytes.begin(), bytes.end()), path, silhouettes);
}

}  // namespace tessera::bench
