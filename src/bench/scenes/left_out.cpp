#include "bench/scenes/left_out.h"

#include <map>
#include <numeric>

#include "core/replacing/draws.h"

namespace tessera::bench {
namespace {

/// The numbers below `count` in a random order.
std::vector<std::size_t> shuffled(std::size_t count, Draws& draws) {
  std::vector<std::size_t> order(count);
  std::iota(order.begin(), order.end(), std::size_t(0));
  for (std::size_t i = count; i > 1; --i) std::swap(order[i - 1], order[draws.below(i)]);
  return order;
}

/// The silhouettes of each class, as indices.
std::vector<std::vector<std::size_t>> classes_of(const std::vector<Silhouette>& silhouettes) {
  std::map<std::string, std::vector<std::size_t>> by_name;
  for (std::size_t i = 0; i < silhouettes.size(); ++i) {
    by_name[class_of(silhouettes[i])].push_back(i);
  }
  std::vector<std::vector<std::size_t>> classes;
  for (auto& [name, members] : by_name) classes.push_back(std::move(members));
  return classes;
}

/// Forms groups from the members in random order, each with its twins, and leaves every second group out.
void leave_out_half(const std::vector<std::size_t>& members, const Twins& twins, Draws& draws,
                    std::vector<bool>& left_out) {
  // Mirror images count, too: the library may hold them.
  const auto are_alike = [&](std::size_t a, std::size_t b) {
    return twins.are_twins(a, b) || twins.are_twins(a, b, true);
  };
  std::vector<bool> taken(left_out.size());
  bool leaves_out = draws.below(2) == 1;
  for (const std::size_t start : shuffled(members.size(), draws)) {
    if (taken[members[start]]) continue;
    std::vector<std::size_t> group = {members[start]};
    taken[members[start]] = true;
    for (std::size_t k = 0; k < group.size(); ++k) {
      if (leaves_out) left_out[group[k]] = true;
      for (const std::size_t other : members) {
        if (taken[other] || !are_alike(group[k], other)) continue;
        taken[other] = true;
        group.push_back(other);
      }
    }
    leaves_out = !leaves_out;
  }
}

}  // namespace

std::vector<bool> chosen_left_out(const std::vector<Silhouette>& silhouettes, const Twins& twins, LeftOut kind,
                                  std::uint64_t seed) {
  std::vector<bool> left_out(silhouettes.size());
  Draws draws(seed);
  const std::vector<std::vector<std::size_t>> classes = classes_of(silhouettes);
  if (kind == LeftOut::classes) {
    const std::vector<std::size_t> order = shuffled(classes.size(), draws);
    for (std::size_t k = 0; k < classes.size() / 2; ++k) {
      for (const std::size_t member : classes[order[k]]) left_out[member] = true;
    }
  } else if (kind == LeftOut::shapes) {
    for (const std::vector<std::size_t>& members : classes) leave_out_half(members, twins, draws, left_out);
  }
  return left_out;
}

void leave_out(const std::vector<bool>& left_out, SilhouetteLibrary& library) {
  std::erase_if(library.shapes, [&](const KnownSilhouette& shape) { return left_out[shape.silhouette]; });
}

}  // namespace tessera::bench
