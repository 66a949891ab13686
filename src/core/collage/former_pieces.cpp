#include "core/collage/former_pieces.h"

#include <algorithm>
#include <map>
#include <set>

#include "core/matching/stances.h"
#include "core/matching/use_limits.h"

namespace tessera {
namespace {

constexpr float kSamePlace = 0.5f;  // of the former piece's size, between centres

class ReplacementRules {
 public:
  ReplacementRules(const CollageSettings& settings, const std::vector<std::uint32_t>& silhouettes,
                   const std::vector<std::uint32_t>& drawings)
      : whole_(settings, std::uint32_t(silhouettes.size())),
        uses_(settings.pieces, settings.wishes),
        silhouettes_(silhouettes),
        drawings_(drawings),
        standing_(drawings.size(), 0) {
    for (const GivenPiece& piece : settings.wishes.given) ++standing_[drawings_[index_of(piece.shape)]];
  }

  bool others_than(const TakenOut& piece) {
    const std::uint32_t own = index_of(piece.shape);
    if (standing_[drawings_[own]] < uses_.least(piece.shape)) return false;
    const std::set<std::uint32_t>& open = open_in(piece.region);
    return std::any_of(open.begin(), open.end(), [&](std::uint32_t other) { return other != silhouettes_[own]; });
  }

 private:
  /// Silhouettes that are open in the region; at most two, as more are not needed.
  const std::set<std::uint32_t>& open_in(std::uint32_t region) {
    const auto [at, is_new] = open_.try_emplace(region);
    if (!is_new) return at->second;
    const StanceTable table = whole_.limited({.region = region});
    for (std::uint32_t i = 0; i < table.open_shapes() && at->second.size() < 2; ++i) {
      const ShapeId shape = table.open_shape(i);
      const int most = uses_.most(shape);
      if (most == 0 || standing_[drawings_[index_of(shape)]] < most) at->second.insert(silhouettes_[index_of(shape)]);
    }
    return at->second;
  }

  StanceTable whole_;
  UseLimits uses_;
  const std::vector<std::uint32_t>& silhouettes_;
  const std::vector<std::uint32_t>& drawings_;
  std::vector<int> standing_;  // by drawing
  std::map<std::uint32_t, std::set<std::uint32_t>> open_;
};

}  // namespace

bool is_at_former_place(const Similarity& then, const Similarity& now, const Period& period) {
  const Vec2 apart = period.nearest(now.translation(), then.translation()) - then.translation();
  const float near_px = kSamePlace * then.scale();
  return dot(apart, apart) < near_px * near_px;
}

std::vector<bool> may_be_replaced(const std::vector<TakenOut>& pieces, const CollageSettings& settings,
                                  const std::vector<std::uint32_t>& silhouettes,
                                  const std::vector<std::uint32_t>& drawings) {
  ReplacementRules who(settings, silhouettes, drawings);
  std::vector<bool> others;
  for (const TakenOut& piece : pieces) others.push_back(who.others_than(piece));
  return others;
}

}  // namespace tessera
