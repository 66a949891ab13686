#include "bench/blocking/silhouette_case.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/base/error.h"
#include "text/number_text.h"

namespace tessera::bench {
namespace {

constexpr double kMostNoise_px = 20;
constexpr double kMostSize = 16;
constexpr int kBestQuality = 100;

std::string shown_number(double value) { return std::isnan(value) ? "nan" : significant(value, 3); }

}  // namespace

void check(const SilhouetteOptions& options) {
  if (!(options.noise_px >= 0 && options.noise_px <= kMostNoise_px)) {
    throw InputError("--noise: found " + shown_number(options.noise_px) + "; allowed: 0 to 20 px");
  }
  if (options.size && !(*options.size >= 1 / kMostSize && *options.size <= kMostSize)) {
    throw InputError("--size: found " + shown_number(*options.size) + "; allowed: 0.0625 to 16");
  }
  if (options.jpeg_quality < 0 || options.jpeg_quality > kBestQuality) {
    throw InputError("--jpeg: found " + std::to_string(options.jpeg_quality) + "; allowed: 1 to 100, or 0 for none");
  }
}

std::size_t SilhouetteCase::queries() const {
  return options.queries == 0 ? silhouettes.size() : std::min(options.queries, silhouettes.size());
}

std::size_t SilhouetteCase::silhouette_of(std::size_t query) const { return query * silhouettes.size() / queries(); }

SilhouetteCase read_silhouette_case(const SilhouetteOptions& options) {
  SilhouetteCase run{options, read_silhouettes(options.shapes), {}, {}};
  if (!options.twins.empty()) run.twins = read_twins(options.twins, run.silhouettes);
  run.library = make_silhouette_library(run.silhouettes, options.mirrors);
  if (run.library.shapes.empty()) throw InputError("--shapes: no silhouette of " + options.shapes + " makes a shape");
  return run;
}

View random_view(const SilhouetteOptions& options, Draws& draws) {
  View view;
  view.turned_rad = 2 * std::numbers::pi * double(draws.unit());
  const double any_size = std::exp2(double(draws.unit()) - 0.5);
  view.size = options.size.value_or(options.scale_known ? 1 : any_size);
  view.jpeg_quality = options.jpeg_quality;
  view.noise_px = options.noise_px;
  return view;
}

ClippedQuery told_query(std::vector<Curve> curves, const View& view, const SilhouetteOptions& options) {
  ClippedQuery query{std::move(curves), view.noise_px, {}};
  if (options.scale_known) query.size = view.size;
  return query;
}

nlohmann::ordered_json case_json(const SilhouetteCase& run) {
  using Json = nlohmann::ordered_json;
  const SilhouetteOptions& options = run.options;
  return {{"shapes", options.shapes},
          {"silhouettes", run.silhouettes.size()},
          {"library_shapes", run.library.shapes.size()},
          {"left_out", run.library.left_out},
          {"twin_pairs", run.twins.size()},
          {"edge", options.edge_removed ? "removed" : "counted"},
          {"scale", options.scale_known ? "known" : "unknown"},
          {"size", options.size ? Json(*options.size) : Json()},
          {"noise_px", options.noise_px},
          {"jpeg_quality", options.jpeg_quality > 0 ? Json(options.jpeg_quality) : Json()},
          {"seed", options.seed}};
}

std::string case_text(const SilhouetteCase& run) {
  const SilhouetteOptions& options = run.options;
  std::string text =
      std::to_string(run.silhouettes.size()) + " silhouettes, " + std::to_string(run.library.shapes.size()) +
      " shapes in the library, " + std::to_string(run.twins.size()) + " pairs of twins. Queries: turned, " +
      (options.size ? shown_number(*options.size) + " times the size, " : "") + "the edge of what hides them " +
      (options.edge_removed ? "removed" : "counted as boundary") + ", the scale " +
      (options.scale_known ? "known" : "unknown") + ", noise of " + shown_number(options.noise_px) + " px" +
      (options.jpeg_quality > 0 ? ", JPEG of quality " + std::to_string(options.jpeg_quality) : "") +
      ".\nTimes are processor time of one core.\n";
  if (!run.library.left_out.empty()) {
    text += std::to_string(run.library.left_out.size()) + " silhouettes are no shapes, and are never found:";
    for (const std::string& name : run.library.left_out) text += " " + name;
    text += "\n";
  }
  return text;
}

}  // namespace tessera::bench
