#include <algorithm>

#include "bench/benchmarks.h"
#include "bench/devices.h"
#include "bench/inputs/model_file.h"
#include "bench/inputs/varied_shapes.h"
#include "core/base/error.h"
#include "core/quality/quality.h"
#include "master/collage_loop.h"
#include "text/number_text.h"
#include "text/text_table.h"
#include "worker/device_group.h"

namespace tessera::bench {
namespace {

/// Means of collages that differ only in their seeds.
struct Means {
  double coverage = 0;
  double overlap = 0;
  double shared_boundary = 0;
  double balance = 0;
  double pieces = 0;
  double distinct_shapes = 0;
  double ms_per_piece = 0;
};

void add(Means& means, const Quality& quality, double seconds, double part) {
  means.coverage += part * quality.coverage;
  means.overlap += part * quality.overlap;
  means.shared_boundary += part * quality.shared_boundary;
  means.balance += part * (quality.balance ? quality.balance->evenness : 0);
  means.pieces += part * double(quality.pieces);
  means.distinct_shapes += part * double(quality.distinct_shapes);
  means.ms_per_piece += part * 1000 * seconds / double(std::max<std::size_t>(1, quality.pieces));
}

void add_row(std::uint32_t shapes, std::uint32_t pairs, const Means& means, TextTable& table, Json& rows) {
  table.add({std::to_string(shapes), pairs == 0 ? "none" : std::to_string(pairs), fixed(100 * means.coverage, 2),
             fixed(100 * means.overlap, 3), fixed(100 * means.shared_boundary, 1), fixed(means.balance, 2),
             fixed(means.pieces, 0), fixed(means.distinct_shapes, 0), fixed(means.ms_per_piece, 0)});
  rows.push_back({{"shapes", shapes},
                  {"pairs", pairs},
                  {"coverage_percent", rounded(100 * means.coverage)},
                  {"overlap_percent", rounded(100 * means.overlap)},
                  {"shared_boundary_percent", rounded(100 * means.shared_boundary)},
                  {"size_balance", rounded(means.balance)},
                  {"pieces", rounded(means.pieces)},
                  {"distinct_shapes", rounded(means.distinct_shapes)},
                  {"ms_per_piece", rounded(means.ms_per_piece)}});
}

/// `pairs`: for each sample; 0: only tangent dockings.
CollageSettings with_pairs(CollageSettings settings, std::uint32_t pairs) {
  settings.match.top_percent = pairs == 0 ? 0 : 100;  // as many as asked for, if there are so many
  settings.match.most_pairs = int(pairs);
  return settings;
}

/// The options with defaults for those that are not given.
VarietyOptions whole(VarietyOptions options, bool quick) {
  using Numbers = std::vector<std::uint32_t>;
  if (options.sizes.empty()) options.sizes = quick ? Numbers{10, 30} : Numbers{100, 1000, 10000};
  if (options.pairs.empty()) options.pairs = quick ? Numbers{0, 50} : Numbers{0, 25, 50, 100, 200, 400};
  if (!options.seeds) options.seeds = quick ? 1 : 4;
  return options;
}

void check(const VarietyOptions& options) {
  check_varied_sizes(options.sizes);
  constexpr std::uint32_t kMostPairs = 1'000'000;  // as match.most_pairs
  for (const std::uint32_t pairs : options.pairs) {
    if (pairs > kMostPairs) {
      throw InputError("--pairs: found " + std::to_string(pairs) + "; allowed: 0 to " + std::to_string(kMostPairs));
    }
  }
  if (*options.seeds < 1 || *options.seeds > 100) {
    throw InputError("--seeds: found " + std::to_string(*options.seeds) + "; allowed: 1 to 100");
  }
}

Report empty_report(const Setting& setting, const SquareJob& job, std::size_t originals, int size_px, int seeds) {
  Report report;
  report.json = report_head("variety", setting);
  report.json.update({{"library", job.library},
                      {"originals", originals},
                      {"canvas_px", size_px},
                      {"scale_px", job.scale_px},
                      {"first_seed", job.seed},
                      {"seeds", seeds},
                      {"rows", Json::array()}});
  return report;
}

std::string explanation(const SquareJob& job, std::size_t originals, int size_px, int seeds) {
  return "\nMeans of " + std::to_string(seeds) + " (--seeds) from seed " + std::to_string(job.seed) + " on; " +
         std::to_string(size_px) + " x " + std::to_string(size_px) + " px, pieces of " + short_number(job.scale_px[0]) +
         " to " + short_number(job.scale_px[1]) + " px, not improved. Shapes beyond the\nfile's " +
         std::to_string(originals) +
         " are mirrored and stretched ones. Pairs: docked for each target sample, beside random dockings; none: "
         "random\ndockings alone. Making shapes that the master asks for is left out of the time.\n";
}

/// The inputs that all collages of one benchmark share.
struct Inputs {
  const Setting& setting;
  const SquareJob& job;
  const VarietyOptions& options;
  const Canvas& canvas;
  VariedShapes& shapes;
};

CollageSettings settings_of(const SquareJob& job) {
  CollageSettings settings;
  settings.pieces.min_scale_px = job.scale_px[0];
  settings.pieces.max_scale_px = job.scale_px[1];
  settings.improve.trials = 0;
  return settings;
}

/// Adds a collage of `size` shapes for each number of pairs.
void add_collages(const Inputs& inputs, std::uint32_t size, const CollageSettings& settings,
                  std::vector<Means>& means) {
  const auto& [setting, job, options, canvas, shapes] = inputs;
  setting.progress(std::to_string(size) + " shapes, seed " + std::to_string(settings.seed));
  const MatchingContext context = make_matching_context(settings, size);
  const auto matcher = worker::make_device_matcher(setting.devices, context, {0, size},
                                                   varied_models(shapes, size, context, options.models));
  for (std::size_t i = 0; i < means.size(); ++i) {
    master::SilentObserver silent;
    const double making_s = shapes.making_s();
    const master::CollageResult made =
        master::make_collage(canvas, with_pairs(settings, options.pairs[i]), *matcher, shapes, silent);
    const Quality quality = measure_quality(
        canvas, made.placements, [&source = shapes](ShapeId id) -> const Shape& { return source.shape(id); },
        SizeRange{job.scale_px[0], job.scale_px[1]});
    add(means[i], quality, made.statistics.total_s - (shapes.making_s() - making_s), 1. / *options.seeds);
  }
}

}  // namespace

Report bench_variety(const Setting& setting, const SquareJob& job, const VarietyOptions& asked) {
  const VarietyOptions options = whole(asked, setting.quick);
  check(job);
  check(options);
  const LibraryFile library(job.library);
  VariedShapes shapes(library);
  const int size_px = setting.quick ? std::min(job.size_px, 160) : job.size_px;
  const Canvas canvas = make_rectangle_canvas(size_px, size_px);
  CollageSettings settings = settings_of(job);

  TextTable table({"shapes", "pairs", "coverage %", "overlap %", "shared boundary %", "balance", "pieces", "different",
                   "ms a piece"});
  Report report = empty_report(setting, job, library.size(), size_px, *options.seeds);
  for (const std::uint32_t size : options.sizes) {
    std::vector<Means> means(options.pairs.size());
    for (int k = 0; k < *options.seeds; ++k) {
      settings.seed = job.seed + std::uint64_t(k);
      add_collages({setting, job, options, canvas, shapes}, size, settings, means);
    }
    for (std::size_t i = 0; i < means.size(); ++i) {
      add_row(size, options.pairs[i], means[i], table, report.json["rows"]);
    }
  }
  report.text = table.text() + explanation(job, library.size(), size_px, *options.seeds);
  return report;
}

}  // namespace tessera::bench
