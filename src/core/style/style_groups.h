// Drawings in groups of like style.
#pragma once

#include <cstdint>
#include <vector>

#include "core/style/style_features.h"

namespace tessera {

struct StyleGroup {
  std::vector<std::uint32_t> members;  // by how far they are from the group's mean; the first is the typical one
};

/// So many groups, or as many as there are different styles. Groups that are alike follow each other, the plainest
/// comes first. k-means of several starts, which are drawn from fixed numbers: the same places give the same groups.
std::vector<StyleGroup> style_groups(const std::vector<StylePlace>& places, std::size_t groups);

/// Of the typical drawings of kStyleGroups groups that of the largest: the style that prevails. `places` is not empty.
std::uint32_t prevailing_style(const std::vector<StylePlace>& places);

/// An eye tells so many apart in Debian's clip art: silhouettes, line art, flat, outlined, shaded, and what is between.
inline constexpr std::size_t kStyleGroups = 8;

}  // namespace tessera
