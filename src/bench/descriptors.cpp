#include <algorithm>
#include <cmath>
#include <filesystem>
#include <functional>

#include "bench/benchmarks.h"
#include "bench/blocking/known_silhouettes.h"
#include "bench/devices.h"
#include "bench/inputs/formula_shapes.h"
#include "bench/line_plot.h"
#include "bench/segments/collage_picture.h"
#include "bench/segments/segment_matcher.h"
#include "bench/segments/timed_collage.h"
#include "core/base/error.h"
#include "core/matching/match_round.h"
#include "core/quality/quality.h"
#include "files/atomic_file.h"
#include "text/number_text.h"
#include "text/text_table.h"

namespace tessera::bench {
namespace {

constexpr std::size_t kMostShapes = 35;  // as in the paper
constexpr std::size_t kQuickShapes = 6;
constexpr double kUsualMinutes = 1;
constexpr double kQuickMinutes = 0.05;
constexpr double kMostMinutes = 24 * 60;
constexpr int kMostPieces = 1000;
/// Points of a segment. The paper of shape context uses 100 for a whole boundary; a segment is about a fifth of one.
constexpr int kContextPointsOfSegment = 20;

void check(const DescriptorsOptions& options) {
  if (options.minutes && !(*options.minutes > 0 && *options.minutes <= kMostMinutes)) {
    throw InputError("--minutes: found " + short_number(*options.minutes) + "; allowed: more than 0, up to 1440");
  }
  if (options.pieces < 0 || options.pieces > kMostPieces) {
    throw InputError("--pieces: found " + std::to_string(options.pieces) + "; allowed: 1 to 1000, or 0 for no limit");
  }
}

std::vector<Shape> shapes_of_folder(const std::string& folder, std::size_t most) {
  std::vector<Shape> shapes;
  for (const Silhouette& silhouette : first_of_each_class(read_silhouettes(folder))) {
    if (shapes.size() == most) break;
    if (std::optional<Shape> shape = shape_of_mask(silhouette.mask)) shapes.push_back(std::move(*shape));
  }
  if (shapes.size() < 2) {
    throw InputError("--shapes: found silhouettes of " + std::to_string(shapes.size()) +
                     (shapes.size() == 1 ? " class in " : " classes in ") + folder +
                     "; needed: 2 or more classes, named by what stands before the last dash of a file's name");
  }
  return shapes;
}

/// One way of finding dockings.
struct DescriptorMethod {
  std::string name;
  CollageSettings settings;
  MakeMatcher make;
  std::function<std::uint64_t(const TimedCollage&)> comparisons;
};

/// Runs all methods with the same shapes, square and limits.
class DescriptorRace {
 public:
  DescriptorRace(GivenShapes& shapes, const CollageLimits& limits)
      : shapes_(shapes),
        limits_(limits),
        collage_(make_seeded_collage(shapes.all().size())),
        context_(make_matching_context(collage_.settings, std::uint32_t(shapes.all().size()))),
        models_(models_of(shapes.all(), context_)) {}

  const Canvas& canvas() const { return collage_.canvas; }

  std::vector<DescriptorMethod> methods() const {
    return {pads(), segments("shape context", [] { return make_shape_context(kContextPointsOfSegment); }),
            segments("Hu moments", make_hu_moments)};
  }

  TimedCollage run(const DescriptorMethod& method) const {
    return make_timed_collage(collage_, method.settings, shapes_, limits_, method.make);
  }

  Quality quality(const TimedCollage& made) const {
    return measure_quality(canvas(), made.placements,
                           [this](ShapeId id) -> const Shape& { return shapes_.all()[index_of(id)]; });
  }

 private:
  DescriptorMethod pads() const {
    return {"PAD", collage_.settings,
            [this](const TimeIsOver&) { return std::make_unique<ReferenceMatcher>(context_, 0, models_); },
            [](const TimedCollage& made) { return made.statistics.docking_choices; }};
  }

  /// The method with segments. It docks as many pairs for a target sample as the method with PADs.
  DescriptorMethod segments(const std::string& name,
                            const std::function<std::unique_ptr<ShapeDescriptor>()>& make_descriptor) const {
    const std::uint64_t pads = pads_per_shape(context_) * context_.library_shapes;
    const std::size_t pairs = match_plan(collage_.settings.match, pads).pairs_per_sample;
    const CollageSettings settings = segment_settings(collage_.settings);
    return {name, settings,
            [this, settings, make_descriptor, pairs](const TimeIsOver& time_is_over) {
              return std::make_unique<SegmentMatcher>(
                  settings, context_, shapes_.all(), models_,
                  SegmentMatching{make_descriptor(), pairs, stop_check(time_is_over)});
            },
            [](const TimedCollage& made) { return dynamic_cast<const SegmentMatcher&>(*made.matcher).compared(); }};
  }

  GivenShapes& shapes_;
  CollageLimits limits_;
  SeededCollage collage_;
  MatchingContext context_;
  std::vector<ShapeModel> models_;
};

double pieces_a_minute(const TimedCollage& made, double seconds) { return 60 * double(made.pieces()) / seconds; }

std::string why_ended(const TimedCollage& made) {
  return made.statistics.stopped_by ? std::string(stop_word(*made.statistics.stopped_by)) : "";
}

/// The table, the plot and the rows of the report, to which each method is added.
struct DescriptorsShown {
  TextTable table{{"descriptor", "pieces", "processor s", "wall s", "pieces a minute", "a wall minute", "comparisons",
                   "coverage %", "shared boundary %", "ended by"}};
  Panel panel{"Pieces placed", "processor time, ms", "pieces", false, 1, {}};
  Json rows = Json::array();

  void add(const DescriptorMethod& method, const TimedCollage& made, const Quality& quality) {
    const std::uint64_t comparisons = method.comparisons(made);
    table.add({method.name, std::to_string(made.pieces()), fixed(made.processor_s, 2), fixed(made.wall_s, 2),
               fixed(pieces_a_minute(made, made.processor_s), 1), fixed(pieces_a_minute(made, made.wall_s), 1),
               std::to_string(comparisons), fixed(100 * quality.coverage, 1), fixed(100 * quality.shared_boundary, 1),
               why_ended(made)});
    rows.push_back({{"descriptor", method.name},
                    {"pieces", made.pieces()},
                    {"processor_s", rounded(made.processor_s)},
                    {"wall_s", rounded(made.wall_s)},
                    {"preparation_processor_s", rounded(made.preparation_s)},
                    {"pieces_per_processor_minute", rounded(pieces_a_minute(made, made.processor_s))},
                    {"pieces_per_wall_minute", rounded(pieces_a_minute(made, made.wall_s))},
                    {"comparisons", comparisons},
                    {"coverage_percent", rounded(100 * quality.coverage)},
                    {"overlap_percent", rounded(100 * quality.overlap)},
                    {"shared_boundary_percent", rounded(100 * quality.shared_boundary)},
                    {"stopped_by", why_ended(made)},
                    {"pieces_at_s", Json::array()}});
    PlotCurve curve{method.name, {}, false};
    for (const auto& [seconds, pieces] : made.pieces_at_s) {
      rows.back()["pieces_at_s"].push_back({rounded(seconds), pieces});
      curve.points.emplace_back(std::max(1., 1000 * seconds), double(pieces));
    }
    if (curve.points.empty()) curve.points.emplace_back(std::max(1., 1000 * made.processor_s), 0.);
    panel.curves.push_back(std::move(curve));
  }
};

std::string picture_path(const std::string& stem, std::string name) {
  std::replace(name.begin(), name.end(), ' ', '-');
  return stem + "_" + name + ".png";
}

/// Throws EnvironmentError where the pictures cannot be written; to be called before the work.
void check_pictures_can_be_written(const std::string& stem, const std::vector<DescriptorMethod>& methods) {
  check_plot_can_be_written(stem);
  for (const DescriptorMethod& method : methods) check_can_be_written(picture_path(stem, method.name));
}

std::string explanation(const Canvas& canvas, const CollageSettings& settings, std::size_t shapes, double minutes) {
  return "\n" + std::to_string(shapes) + " shapes, each once, the first of them the seed; " +
         std::to_string(canvas.width_px) + " x " + std::to_string(canvas.height_px) + " px, pieces of " +
         short_number(settings.pieces.min_scale_px) + " to " + short_number(settings.pieces.max_scale_px) +
         " px. Each descriptor has " + short_number(minutes) +
         " minutes of\nprocessor time. Field, docking, refinement, objective and merging are the same for all.\n"
         "PAD compares points. The others compare segments of the target curve with segments of the shapes, which are\n"
         "described beforehand; shape context has " +
         std::to_string(kContextPointsOfSegment) +
         " points a segment. Comparisons: of PADs all pairs, of segments those whose\n"
         "lengths imply an allowed size and that bend alike. In plain C++, matching on one thread.\n"
         "Shared boundary: within 2 px of another piece's.\n";
}

}  // namespace

Report bench_descriptors(const Setting& setting, const DescriptorsOptions& options) {
  check(options);
  const double minutes = options.minutes.value_or(setting.quick ? kQuickMinutes : kUsualMinutes);
  const std::size_t most = setting.quick ? kQuickShapes : kMostShapes;
  const std::string stem = std::filesystem::path(setting.out).replace_extension().string();
  GivenShapes shapes(options.shapes.empty() ? blob_shapes(most) : shapes_of_folder(options.shapes, most));
  const std::size_t count = shapes.all().size();

  const DescriptorRace race(shapes, {60 * minutes, options.pieces});
  const std::vector<DescriptorMethod> methods = race.methods();
  if (!stem.empty()) check_pictures_can_be_written(stem, methods);
  DescriptorsShown shown;
  shown.panel.greatest_y = 5 * std::ceil(double(count) / 5);
  for (const DescriptorMethod& method : methods) {
    setting.progress(method.name);
    const TimedCollage made = race.run(method);
    shown.add(method, made, race.quality(made));
    if (!stem.empty())
      write_collage_picture(race.canvas(), made.placements, shapes.all(), picture_path(stem, method.name));
  }
  if (!stem.empty()) write_plot({shown.panel}, stem);
  Report report;
  report.json = report_head("descriptors", setting);
  report.json.update({{"shapes_folder", options.shapes},
                      {"shapes", count},
                      {"canvas_px", race.canvas().width_px},
                      {"minutes", minutes},
                      {"rows", std::move(shown.rows)}});
  report.text = shown.table.text() + explanation(race.canvas(), methods.front().settings, count, minutes);
  return report;
}

}  // namespace tessera::bench
