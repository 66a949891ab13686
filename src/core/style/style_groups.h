// Divides drawings into groups of similar style.
#pragma once

#include <cstdint>
#include <vector>

#include "core/style/style_features.h"

namespace tessera {

struct StyleGroup {
  std::vector<std::uint32_t> members;  // ascending by distance from the group's mean; the first is the typical one
};

/// At most `groups` groups; fewer if there are fewer different styles. Similar groups follow each other; the plainest
/// comes first. Uses k-means from several starts with fixed random numbers: the same places give the same groups.
std::vector<StyleGroup> style_groups(const std::vector<StylePlace>& places, std::size_t groups);

/// The typical drawing of the largest of kStyleGroups groups: the prevailing style. `places` is not empty.
std::uint32_t prevailing_style(const std::vector<StylePlace>& places);

/// Number of groups that the eye distinguishes in Debian's clip art: silhouettes, line art, flat, outlined, shaded, and
/// mixtures.
inline constexpr std::size_t kStyleGroups = 8;

}  // namespace tessera
