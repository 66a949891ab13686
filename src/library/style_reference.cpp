#include "library/style_reference.h"

#include <array>

#include "core/style/style_groups.h"
#include "library/name_globs.h"

namespace tessera {
namespace {

std::vector<std::uint32_t> chosen_like(const NameIndex& names, const std::vector<std::string>& like) {
  try {
    return chosen_names(names, {like, {}}, "the library");
  } catch (const NamesNotFound& error) {
    throw NamesNotFound("style-like", error.reason());
  }
}

}  // namespace

StylePlace style_reference(const NameIndex& names, const std::vector<StylePlace>& places,
                           const std::vector<std::string>& like) {
  if (like == std::vector<std::string>{kPrevailingStyle}) return places[prevailing_style(places)];
  const std::vector<std::uint32_t> chosen = chosen_like(names, like);
  std::array<double, kStyleNumbers> sum{};
  for (const std::uint32_t shape : chosen) {
    for (std::size_t k = 0; k < kStyleNumbers; ++k) sum[k] += double(places[shape][k]);
  }
  StylePlace mean;
  for (std::size_t k = 0; k < kStyleNumbers; ++k) mean[k] = float(sum[k] / double(chosen.size()));
  return mean;
}

std::string unknown_style_text(const std::string& library, const std::string& shape) {
  return library + " does not know the style of " + shape + ", because an older version built it; build it again";
}

}  // namespace tessera
