#include <algorithm>

#include "bench/baselines/full_rematch.h"
#include "bench/baselines/paper_matcher.h"
#include "bench/baselines/random_filling.h"
#include "bench/benchmarks.h"
#include "bench/devices.h"
#include "bench/inputs/library_matcher.h"
#include "core/field/free_field.h"
#include "core/quality/quality.h"
#include "core/settings/tuning.h"
#include "library/library_shapes.h"
#include "library/storage/shape_models.h"
#include "text/number_text.h"
#include "text/text_table.h"

namespace tessera::bench {
namespace {

struct FilledJob {
  std::string engine;
  std::vector<Placement> placements;
  double total_s = 0;
};

/// One job and the engines that run it.
class Comparison {
 public:
  Comparison(const LibraryFile& library, ShapeSource& shapes, const Canvas& canvas, const CollageSettings& settings,
             const std::string& devices_use)
      : library_(library),
        shapes_(shapes),
        canvas_(canvas),
        settings_(settings),
        devices_use_(devices_use) {}

  FilledJob tessera(const std::string& name, const CollageSettings& settings) {
    return engine(name, settings, *library_matcher(library_, library_.size(), settings, devices_use_));
  }
  FilledJob tessera() { return tessera("tessera", settings_); }

  FilledJob pad_only() {
    CollageSettings settings = settings_;
    settings.match.tangent_dockings = 0;
    return tessera("PAD only", settings);
  }

  FilledJob tangent_only() {
    CollageSettings settings = settings_;
    settings.match.top_percent = 0;
    return tessera("tangent only", settings);
  }

  FilledJob paper_rule() {
    const CollageSettings settings = paper_settings(settings_);
    const std::uint32_t count = std::uint32_t(library_.size());
    const MatchingContext context = make_matching_context(settings, count);
    PaperMatcher matcher(settings, context, read_models(library_, {0, count}, context));
    return engine("the paper's rule", settings, matcher);
  }

  FilledJob full_recomputation() {
    const auto matcher = library_matcher(library_, library_.size(), settings_, devices_use_);
    master::CollageResult result = make_collage_afresh(canvas_, settings_, *matcher, shapes_);
    return {"all samples each round", std::move(result.placements), result.statistics.total_s};
  }

  FilledJob random_filling(double seconds) {
    return {"random filling", fill_at_random(canvas_, settings_, shapes_, std::uint32_t(library_.size()), seconds),
            seconds};
  }

  Quality quality(const FilledJob& outcome) {
    return measure_quality(canvas_, outcome.placements,
                           [this](ShapeId id) -> const Shape& { return shapes_.shape(id); });
  }

 private:
  FilledJob engine(const std::string& name, const CollageSettings& settings, Matcher& matcher) {
    master::SilentObserver silent;
    master::CollageResult result = master::make_collage(canvas_, settings, matcher, shapes_, silent);
    return {name, std::move(result.placements), result.statistics.total_s};
  }

  const LibraryFile& library_;
  ShapeSource& shapes_;
  const Canvas& canvas_;
  CollageSettings settings_;
  std::string devices_use_;
};

/// A square whose region leaves out the first shape in its middle, the seed. Straight sides have no PADs (the paper's
/// first limitation): without a seed PADs alone could not start.
Canvas seeded_canvas(int size_px, const PieceSettings& pieces, ShapeSource& shapes) {
  Canvas canvas = make_rectangle_canvas(size_px, size_px);
  PieceSettings widest = pieces;
  widest.max_scale_px = 8.f * float(size_px);  // stamps cover the whole canvas: their distances are right everywhere
  FreeField free(canvas, widest);
  const float scale_px = std::min(pieces.max_scale_px, 0.3f * float(size_px));
  free.stamp(shapes.shape(ShapeId{0}), {scale_px, 0, 0.5f * float(size_px), 0.5f * float(size_px)});
  canvas.distance = free.field();
  canvas.area_px2 -= double(scale_px) * scale_px;
  return canvas;
}

void add_engine(TextTable& table, Json& engines, const FilledJob& outcome, const Quality& q) {
  table.add({outcome.engine, fixed(100 * q.coverage, 2), fixed(100 * q.overlap, 3), fixed(100 * q.shared_boundary, 1),
             std::to_string(q.pieces), fixed(outcome.total_s, 1)});
  engines.push_back({{"engine", outcome.engine},
                     {"coverage_percent", rounded(100 * q.coverage)},
                     {"overlap_percent", rounded(100 * q.overlap)},
                     {"outside_percent", rounded(100 * q.outside)},
                     {"shared_boundary_percent", rounded(100 * q.shared_boundary)},
                     {"pieces", q.pieces},
                     {"total_s", rounded(outcome.total_s)}});
}

std::string explanation(std::size_t shapes, int size_px, const SquareJob& job) {
  return std::to_string(shapes) + " shapes, " + std::to_string(size_px) + " x " + std::to_string(size_px) +
         " px, pieces of " + short_number(job.scale_px[0]) + " to " + short_number(job.scale_px[1]) + " px, seed " +
         std::to_string(job.seed) +
         ";\nthe first shape lies in the middle from the start, for straight sides have no PADs.\nPAD only, tangent "
         "only: without the other kind of docking, everything else the same.\n"
         "The paper's rule: K = 1 %, beta = 0.4, delta = 4 px, ends of the first level aligned, objective Z of\n"
         "every candidate; nothing refined, settled or grown; candidates within our limits of overlap (" +
         short_number(100 * kMaxOverlap) + " %) and contact (" + short_number(100 * kLeastMatched) +
         " %).\n"
         "In plain C++ on one thread: its time does not compare.\n"
         "All samples each round: no cut and paste. Random filling: as much time as the first row.\n";
}

}  // namespace

Report bench_alternatives(const Setting& setting, const SquareJob& job) {
  check(job);
  const LibraryFile library(job.library);
  const int size_px = setting.quick ? std::min(job.size_px, 160) : job.size_px;
  CollageSettings settings;
  settings.seed = job.seed;
  settings.pieces.min_scale_px = job.scale_px[0];
  settings.pieces.max_scale_px = job.scale_px[1];
  LibraryShapes shapes(library);
  const Canvas canvas = seeded_canvas(size_px, settings.pieces, shapes);

  Comparison comparison(library, shapes, canvas, settings, setting.devices);
  std::vector<FilledJob> outcomes = {comparison.tessera(), comparison.pad_only(), comparison.tangent_only(),
                                     comparison.paper_rule(), comparison.full_recomputation()};
  outcomes.push_back(comparison.random_filling(outcomes.front().total_s));

  TextTable table({"", "coverage %", "overlap %", "shared boundary %", "pieces", "time s"});
  Report report;
  report.json = report_head("alternatives", setting);
  report.json.update({{"library", job.library},
                      {"shapes", library.size()},
                      {"canvas_px", size_px},
                      {"scale_px", job.scale_px},
                      {"seed", job.seed},
                      {"engines", Json::array()}});
  for (const FilledJob& outcome : outcomes)
    add_engine(table, report.json["engines"], outcome, comparison.quality(outcome));
  report.text = table.text() + "\n" + explanation(library.size(), size_px, job);
  return report;
}

}  // namespace tessera::bench
