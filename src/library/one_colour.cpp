#include "library/one_colour.h"

#include <algorithm>
#include <array>
#include <vector>

#include "library/same_colour.h"

namespace tessera {
namespace {

constexpr double kNearlyAll = 0.95;
constexpr std::size_t kColouredAtATime = 1024;
constexpr LibraryParts kOneColourParts{
    .outline = false, .field = false, .levels = 0, .artwork = false, .original = false};

using LabColour = std::array<float, 3>;

/// The colours of the shapes that have one colour each.
std::vector<LabColour> single_colours(const ShapeLibrary& library) {
  std::vector<LabColour> colours;
  for (std::size_t at = 0; at < library.size(); at += kColouredAtATime) {
    for (const Shape& shape : library.read(at, std::min(library.size(), at + kColouredAtATime), kOneColourParts)) {
      if (shape.colour_spread >= 0 && shape.colour_spread <= kLeastColourDifference) colours.push_back(shape.mean_lab);
    }
  }
  return colours;
}

LabColour median(std::vector<LabColour> colours) {
  LabColour result{};
  for (std::size_t c = 0; c < result.size(); ++c) {
    const auto middle = colours.begin() + std::ptrdiff_t(colours.size() / 2);
    std::nth_element(colours.begin(), middle, colours.end(),
                     [c](const LabColour& a, const LabColour& b) { return a[c] < b[c]; });
    result[c] = (*middle)[c];
  }
  return result;
}

}  // namespace

bool is_of_one_colour(const ShapeLibrary& library) {
  const std::vector<LabColour> colours = single_colours(library);
  const double needed = kNearlyAll * double(library.size());
  if (colours.empty() || double(colours.size()) < needed) return false;
  const LabColour usual = median(colours);
  const auto alike =
      std::count_if(colours.begin(), colours.end(), [&](const LabColour& lab) { return same_colour(lab, usual); });
  return double(alike) >= needed;
}

}  // namespace tessera
