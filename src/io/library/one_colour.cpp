#include "io/library/one_colour.h"

#include <algorithm>
#include <array>
#include <vector>

#include "io/library/same_colour.h"

namespace tessera::io {
namespace {

constexpr double kNearlyAll = 0.95;
constexpr std::size_t kShapesAtATime = 1024;
constexpr LibraryParts kColours{.outline = false, .field = false, .levels = 0, .artwork = false, .original = false};

using Lab = std::array<float, 3>;

/// Of the shapes that have one colour each.
std::vector<Lab> single_colours(const ShapeLibrary& library) {
  std::vector<Lab> colours;
  for (std::size_t at = 0; at < library.size(); at += kShapesAtATime) {
    for (const Shape& shape : library.read(at, std::min(library.size(), at + kShapesAtATime), kColours)) {
      if (shape.colour_spread >= 0 && shape.colour_spread <= kLeastColourDifference) colours.push_back(shape.mean_lab);
    }
  }
  return colours;
}

Lab median(std::vector<Lab> colours) {
  Lab result{};
  for (std::size_t c = 0; c < result.size(); ++c) {
    const auto middle = colours.begin() + std::ptrdiff_t(colours.size() / 2);
    std::nth_element(colours.begin(), middle, colours.end(), [c](const Lab& a, const Lab& b) { return a[c] < b[c]; });
    result[c] = (*middle)[c];
  }
  return result;
}

}  // namespace

bool is_of_one_colour(const ShapeLibrary& library) {
  const std::vector<Lab> colours = single_colours(library);
  const double needed = kNearlyAll * double(library.size());
  if (colours.empty() || double(colours.size()) < needed) return false;
  const Lab usual = median(colours);
  const auto alike =
      std::count_if(colours.begin(), colours.end(), [&](const Lab& lab) { return same_colour(lab, usual); });
  return double(alike) >= needed;
}

}  // namespace tessera::io
