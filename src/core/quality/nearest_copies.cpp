#include "core/quality/nearest_copies.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <unordered_map>

namespace tessera {
namespace {

struct Centre {
  Vec2 position_px;
  std::uint32_t piece;
};

bool to_the_left(const Centre& a, const Centre& b) { return a.position_px.x < b.position_px.x; }

/// The centres of the pieces of one shape with all of their images, from left to right.
std::vector<Centre> centres_of(const std::vector<std::uint32_t>& group, const std::vector<JudgedPiece>& pieces,
                               const Period& period) {
  std::vector<Centre> centres;
  for (const std::uint32_t piece : group) {
    const Vec2 own = period.wrapped(pieces[piece].centre_px);
    for (const Vec2 offset : period.offsets()) centres.push_back({own + offset, piece});
  }
  std::sort(centres.begin(), centres.end(), to_the_left);
  return centres;
}

/// Takes the distance of `other` if it is another piece and nearer. False if neither it nor any centre beyond it can be
/// nearer.
bool take_nearer(const Centre& here, const Centre& other, float& nearest_px) {
  if (std::abs(other.position_px.x - here.position_px.x) >= nearest_px) return false;
  if (other.piece != here.piece) nearest_px = std::min(nearest_px, norm(other.position_px - here.position_px));
  return true;
}

float nearest_copy_px(const std::vector<Centre>& centres, const Centre& here) {
  float nearest_px = INFINITY;
  const auto from = std::lower_bound(centres.begin(), centres.end(), here, to_the_left);
  for (auto at = from; at != centres.end() && take_nearer(here, *at, nearest_px); ++at) {
  }
  for (auto at = from; at != centres.begin() && take_nearer(here, *(at - 1), nearest_px); --at) {
  }
  return nearest_px;
}

}  // namespace

std::optional<double> median_copy_distance_px(const std::vector<JudgedPiece>& pieces, const Period& period) {
  std::unordered_map<std::string, std::vector<std::uint32_t>> groups;
  for (std::uint32_t i = 0; i < pieces.size(); ++i) {
    if (!pieces[i].shape.empty()) groups[pieces[i].shape].push_back(i);
  }
  std::vector<float> distances_px;
  for (const auto& [name, group] : groups) {
    const std::vector<Centre> centres = centres_of(group, pieces, period);
    for (const std::uint32_t piece : group) {
      distances_px.push_back(nearest_copy_px(centres, {period.wrapped(pieces[piece].centre_px), piece}));
    }
  }
  if (distances_px.empty()) return {};
  std::sort(distances_px.begin(), distances_px.end());
  const std::size_t last = distances_px.size() - 1;
  const double median_px = (double(distances_px[last / 2]) + double(distances_px[last - last / 2])) / 2;
  return std::isfinite(median_px) ? std::optional(median_px) : std::nullopt;
}

}  // namespace tessera
