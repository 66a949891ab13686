#include "core/style/style_groups.h"

#include <algorithm>
#include <limits>
#include <numeric>

#include "core/base/portable_math.h"

namespace tessera {
namespace {

/// Number of starts: k-means finds a local optimum, and more starts hardly improve the best one.
constexpr int kStarts = 12;
constexpr int kMostSteps = 60;

struct Division {
  std::vector<StylePlace> means;
  std::vector<std::uint32_t> group_of;
  double squares = 0;  // sum of squared distances from the means
};

float squared(float x) { return x * x; }

std::uint32_t nearest_mean(const std::vector<StylePlace>& means, const StylePlace& place) {
  std::uint32_t nearest = 0;
  for (std::uint32_t g = 1; g < means.size(); ++g) {
    if (style_distance(means[g], place) < style_distance(means[nearest], place)) nearest = g;
  }
  return nearest;
}

/// The first means by k-means++ (Arthur and Vassilvitskii): each is drawn by its squared distance from those before.
/// Fewer than `groups` if there are fewer styles.
std::vector<StylePlace> first_means(const std::vector<StylePlace>& places, std::size_t groups, int start) {
  const auto draw = [&](std::size_t k) {
    return double(unit_float(std::uint32_t(mix_bits(std::uint64_t(start) << 32 | std::uint64_t(k)) >> 32)));
  };
  std::vector<StylePlace> means{places[std::size_t(draw(0) * double(places.size()))]};
  std::vector<double> far(places.size(), std::numeric_limits<double>::max());
  while (means.size() < groups) {
    double all = 0;
    for (std::size_t i = 0; i < places.size(); ++i) {
      far[i] = std::min(far[i], double(squared(style_distance(places[i], means.back()))));
      all += far[i];
    }
    if (all == 0) break;
    double left = draw(means.size()) * all;
    std::size_t i = 0;
    while (i + 1 < places.size() && (left >= far[i] || far[i] == 0)) left -= far[i++];
    means.push_back(places[i]);
  }
  return means;
}

void set_means(const std::vector<StylePlace>& places, Division& division) {
  std::vector<std::array<double, kStyleNumbers>> sums(division.means.size());
  std::vector<double> counts(division.means.size());
  for (std::size_t i = 0; i < places.size(); ++i) {
    const std::uint32_t g = division.group_of[i];
    ++counts[g];
    for (std::size_t k = 0; k < kStyleNumbers; ++k) sums[g][k] += double(places[i][k]);
  }
  for (std::size_t g = 0; g < sums.size(); ++g) {
    if (counts[g] == 0) continue;
    for (std::size_t k = 0; k < kStyleNumbers; ++k) division.means[g][k] = float(sums[g][k] / counts[g]);
  }
}

Division divided(const std::vector<StylePlace>& places, std::size_t groups, int start) {
  Division division{first_means(places, groups, start), {}, 0};
  for (int step = 0; step < kMostSteps; ++step) {
    std::vector<std::uint32_t> group_of;
    for (const StylePlace& place : places) group_of.push_back(nearest_mean(division.means, place));
    const bool settled = group_of == division.group_of;
    division.group_of = std::move(group_of);
    if (settled) break;
    set_means(places, division);
  }
  for (std::size_t i = 0; i < places.size(); ++i)
    division.squares += double(squared(style_distance(places[i], division.means[division.group_of[i]])));
  return division;
}

Division best_division(const std::vector<StylePlace>& places, std::size_t groups) {
  Division best = divided(places, groups, 0);
  for (int start = 1; start < kStarts; ++start) {
    Division other = divided(places, groups, start);
    if (other.squares < best.squares) best = std::move(other);
  }
  return best;
}

/// An order of the groups: from the plainest one, nearest to 0 in all features, each time to the nearest remaining one.
std::vector<std::uint32_t> order_by_similarity(const std::vector<StylePlace>& means) {
  std::vector<std::uint32_t> left(means.size()), way;
  std::iota(left.begin(), left.end(), 0u);
  StylePlace here{};
  while (!left.empty()) {
    const auto next = std::min_element(left.begin(), left.end(), [&](std::uint32_t a, std::uint32_t b) {
      return style_distance(means[a], here) < style_distance(means[b], here);
    });
    here = means[*next];
    way.push_back(*next);
    left.erase(next);
  }
  return way;
}

}  // namespace

std::vector<StyleGroup> style_groups(const std::vector<StylePlace>& places, std::size_t groups) {
  if (places.empty()) return {};
  const Division division = best_division(places, groups);
  std::vector<StyleGroup> all(division.means.size());
  for (std::uint32_t i = 0; i < places.size(); ++i) all[division.group_of[i]].members.push_back(i);
  std::vector<StyleGroup> ordered;
  for (const std::uint32_t g : order_by_similarity(division.means)) {
    if (all[g].members.empty()) continue;
    std::stable_sort(all[g].members.begin(), all[g].members.end(), [&](std::uint32_t a, std::uint32_t b) {
      return style_distance(places[a], division.means[g]) < style_distance(places[b], division.means[g]);
    });
    ordered.push_back(std::move(all[g]));
  }
  return ordered;
}

std::uint32_t prevailing_style(const std::vector<StylePlace>& places) {
  const std::vector<StyleGroup> groups = style_groups(places, kStyleGroups);
  const auto largest = std::max_element(groups.begin(), groups.end(), [](const StyleGroup& a, const StyleGroup& b) {
    return a.members.size() < b.members.size();
  });
  return largest->members.front();
}

}  // namespace tessera
