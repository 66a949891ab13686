#include "bench/scenes/scene_queries.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "bench/scenes/changed_outline.h"
#include "bench/scenes/scene.h"
#include "core/base/error.h"

namespace tessera::bench {
namespace {

/// Most other silhouettes that are tried for one query. Each is scaled larger than the one before, so that it can also
/// hide long shapes: twice the area after kTriesToDouble.
constexpr int kMostOthersTried = 64;
constexpr double kTriesToDouble = 16;

/// The visible part of a scene, and the silhouettes that it shows.
struct VisiblePart {
  cv::Mat seen;
  HiderDistance from_hider;  // empty: all is boundary
  std::vector<std::size_t> shown;
};

struct SceneMaker {
  const SilhouetteCase& run;
  std::size_t silhouette;
  double hidden;
  const std::vector<std::size_t>& others;
  Draws& draws;

  const cv::Mat& mask(std::size_t of) const { return run.silhouettes[of].mask; }

  VisiblePart behind(const Scene& scene) const {
    return {scene.seen(), run.options.edge_removed ? distance_from_hider(scene) : HiderDistance(), {silhouette}};
  }

  /// Makes a view from the silhouette and one of the others, the first with which `make` succeeds.
  template <class Make>
  std::optional<VisiblePart> with_another(const Make& make) const {
    for (int attempt = 0; attempt < kMostOthersTried && !others.empty(); ++attempt) {
      const std::size_t other = others[draws.below(others.size())];
      if (run.twins.are_twins(other, silhouette)) continue;
      if (std::optional<VisiblePart> sight = make(other, attempt)) return sight;
    }
    return std::nullopt;
  }

  std::optional<VisiblePart> covered(bool known) const {
    return with_another([&](std::size_t upper, int attempt) -> std::optional<VisiblePart> {
      const double times_as_large = std::exp2(double(draws.unit()) - 0.5 + attempt / kTriesToDouble);
      const std::optional<Scene> scene = covered_scene(mask(silhouette), mask(upper), hidden, times_as_large, draws);
      if (!scene) return std::nullopt;
      return known ? behind(*scene) : VisiblePart{scene->united(), {}, {silhouette, upper}};
    });
  }

  std::optional<VisiblePart> changed() const {
    const std::vector<Vec2> outline = outer_outline(mask(silhouette));
    return with_another([&](std::size_t other, int) -> std::optional<VisiblePart> {
      const std::optional<ChangedOutline> changed = changed_outline(outline, outer_outline(mask(other)), hidden, draws);
      if (!changed) return std::nullopt;
      return VisiblePart{filled_mask(changed->points), {}, {silhouette, other}};
    });
  }
};

using MakeSight = std::function<std::optional<VisiblePart>(const SceneMaker&)>;

const std::vector<std::pair<std::string, MakeSight>>& makers() {
  static const std::vector<std::pair<std::string, MakeSight>> all = {
      {"clipped", [](const SceneMaker& m) { return m.behind(clipped_scene(m.mask(m.silhouette), m.hidden)); }},
      {"covered", [](const SceneMaker& m) { return m.covered(true); }},
      {"bars", [](const SceneMaker& m) { return m.behind(bars_scene(m.mask(m.silhouette), m.hidden, m.draws)); }},
      {"branch", [](const SceneMaker& m) { return m.behind(branch_scene(m.mask(m.silhouette), m.hidden, m.draws)); }},
      {"union", [](const SceneMaker& m) { return m.covered(false); }},
      {"changed", [](const SceneMaker& m) { return m.changed(); }}};
  return all;
}

}  // namespace

const std::vector<std::string>& scene_kinds() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> all;
    for (const auto& [name, make] : makers()) all.push_back(name);
    return all;
  }();
  return names;
}

std::optional<SceneQuery> scene_query(const SilhouetteCase& run, const std::string& kind, std::size_t silhouette,
                                      int hidden_percent, const std::vector<std::size_t>& others) {
  const auto maker = std::find_if(makers().begin(), makers().end(), [&](const auto& m) { return m.first == kind; });
  Draws draws(mix_bits(run.options.seed + std::uint64_t(maker - makers().begin()) + 1) ^
              (std::uint64_t(silhouette) << 8) ^ std::uint64_t(hidden_percent));
  const View view = random_view(run.options, draws);
  const std::optional<VisiblePart> sight = maker->second({run, silhouette, hidden_percent / 100., others, draws});
  if (!sight) return std::nullopt;
  return SceneQuery{told_query(seen_curves(sight->seen, view, sight->from_hider, draws), view, run.options),
                    sight->shown};
}

}  // namespace tessera::bench
