#include <algorithm>
#include <memory>

#include "bench/benchmarks.h"
#include "bench/device_peak.h"
#include "bench/devices.h"
#include "bench/inputs/formula_shapes.h"
#include "bench/inputs/varied_shapes.h"
#include "bench/timing.h"
#include "core/field/free_field.h"
#include "core/field/opened_field.h"
#include "core/field/target_curve.h"
#include "core/matching/match_round.h"
#include "core/matching/pair_limits.h"
#include "text/number_text.h"
#include "text/text_table.h"
#include "worker/devices/opencl_devices.h"
#include "worker/opencl_matcher.h"

namespace tessera::bench {
namespace {

constexpr std::uint32_t kShapesOfPlainLoop = 1000;

/// Shapes, and the free region that is left when some of them lie in a grid on the canvas.
struct PairScene {
  CollageSettings settings;
  std::vector<TargetSample> samples;
  MatchingContext context;
  std::uint32_t shapes = 0;
  std::shared_ptr<const ModelSource> models;
  std::vector<ShapeModel> some_models;  // the first models
  double pads = 0;                      // in the library
  std::string kind;

  double pairs() const { return double(samples.size()) * pads; }
  std::uint64_t wanted() const { return match_plan(settings.match, std::uint64_t(pads)).pairs_per_sample; }
};

void lay_grid(FreeField& free, const std::vector<Shape>& shapes, int size_px) {
  constexpr int kPitch_px = 100;
  std::size_t next = 0;
  for (int y = kPitch_px / 2; y < size_px; y += kPitch_px) {
    for (int x = kPitch_px / 2; x < size_px; x += kPitch_px) {
      free.stamp(shapes[next++ % shapes.size()], {60, 0, float(x), float(y)});
    }
  }
}

/// Sets models and samples; `laid`: the shapes on the canvas.
void set_scene(PairScene& scene, const std::vector<Shape>& laid, std::size_t samples, int size_px) {
  scene.pads = double(pads_per_shape(scene.context)) * double(scene.shapes);
  scene.some_models = scene.models->models({0, std::min(scene.shapes, kShapesOfPlainLoop)}, {});
  FreeField free(make_rectangle_canvas(size_px, size_px), scene.settings.pieces);
  lay_grid(free, laid, size_px);
  const OpenedField opened(free, scene.settings.pieces);
  TargetCurve curve(scene.settings.pieces, scene.settings.match.pad);
  curve.retrace(opened, free.field().origin, {free.field().value.bounds()});
  for (const SampleId id : curve.samples()) {
    if (scene.samples.size() < samples) scene.samples.push_back(curve.sample(id));
  }
}

PairScene make_scene(const PairsOptions& options, bool quick) {
  PairScene scene;
  const std::size_t samples = quick ? 100 : options.library.empty() ? 1000 : 250;
  const int size_px = quick ? 300 : 1000;
  if (options.library.empty()) {
    scene.shapes = options.shapes > 0 ? options.shapes : quick ? 20 : 1000;
    scene.context = make_matching_context(scene.settings, scene.shapes);
    const std::vector<Shape> blobs = blob_shapes(scene.shapes);
    const auto models = std::make_shared<std::vector<ShapeModel>>(models_of(blobs, scene.context));
    scene.models = std::make_shared<MadeModels>([models](const ShapeRange& range) {
      return std::vector<ShapeModel>(models->begin() + range.begin, models->begin() + range.end);
    });
    scene.kind = "blobs";
    set_scene(scene, blobs, samples, size_px);
  } else {
    const LibraryFile file(options.library);
    const auto varied = std::make_shared<VariedShapes>(file);
    scene.shapes = options.shapes > 0 ? options.shapes : file.size();
    scene.context = make_matching_context(scene.settings, scene.shapes);
    scene.models = std::make_shared<MadeModels>(
        [varied, context = scene.context](const ShapeRange& range) { return varied->models(range, context); });
    scene.kind = "shapes";
    set_scene(scene, varied->shapes({0, std::min(scene.shapes, 100u)}), samples, size_px);
  }
  return scene;
}

/// Times of both methods on the first device, with all shapes on it.
struct DeviceTimes {
  double index_s = 0;
  double scan_s = 0;
  std::uint64_t index_blocks = 0;  // blocks that were visited
  std::uint64_t scan_blocks = 0;
};

/// The number of blocks visited to find all pairs within the limits in one search.
std::uint64_t blocks_for(worker::PairStage& stage, const std::vector<worker::SampleRecord>& samples,
                         const std::vector<std::uint32_t>& limits) {
  const std::uint64_t before = stage.search().blocks_visited();
  stage.forget();
  stage.pairs_of(samples, limits);
  return stage.search().blocks_visited() - before;
}

DeviceTimes device_times(const PairScene& scene, const std::string& devices_use, int runs) {
  const worker::DeviceLibrary library(worker::chosen_devices(devices_use).front(), scene.context, {0, scene.shapes},
                                      scene.models);
  const std::vector<worker::SampleRecord> samples =
      worker::make_sample_records(scene.samples, library.match(), library.pad_levels());
  worker::PairStage by_index(library, worker::kStageBytes);
  worker::PairStage by_scan(library, worker::kStageBytes);
  by_scan.search().scan_all();
  DeviceTimes times;
  std::vector<std::uint32_t> limits;
  times.index_s = median_s(runs, [&] {
    by_index.forget();
    by_index.set_samples(samples);
    limits = pair_limits(samples.size(), scene.wanted(), scene.shapes,
                         [&](const std::vector<std::uint32_t>& bins, std::uint32_t segment_stride) {
                           by_index.post_count(bins, segment_stride);
                           return by_index.take_count();
                         });
  });
  // One search as far as needed: the scan does not have to find the limits.
  times.scan_s = median_s(runs, [&] {
    by_scan.forget();
    by_scan.pairs_of(samples, limits);
  });
  times.index_blocks = blocks_for(by_index, samples, limits);
  times.scan_blocks = blocks_for(by_scan, samples, limits);
  return times;
}

/// The time for Equation 1 on every pair, and nothing else.
double plain_s(const PairScene& scene, std::uint64_t& below_beta) {
  const int levels = scene.context.pad.levels;
  return median_s(1, [&] {
    below_beta = 0;
    for (const TargetSample& sample : scene.samples) {
      const QuantisedPad target = quantised(make_pad(sample.pyramid, levels));
      for (const ShapeModel& model : scene.some_models) {
        for (const ModelLevel& level : model.levels) {
          for (const ModelSample& source : level.samples) {
            below_beta += pad_distance(target, source.pad, levels) < scene.context.beta_steps;
          }
        }
      }
    }
  });
}

/// Rates in pairs a second.
struct PairRates {
  int cores = 0;
  int elements = 0;  // in a PAD
  DeviceTimes times;
  double index = 0;
  double device = 0;
  double plain = 0;
  double float_limit = 0;
  double byte_limit = 0;
  double memory_limit = 0;
  double below_beta = 0;  // part of the pairs, whatever their scale
};

PairRates measure(const PairScene& scene, const Setting& setting) {
  PairRates rates;
  rates.cores = compute_units(setting.devices);  // only the first device is measured
  rates.elements = 2 * (scene.context.pad.levels - 1);
  rates.times = device_times(scene, setting.devices, setting.quick ? 2 : 5);
  rates.index = scene.pairs() / rates.times.index_s;
  rates.device = scene.pairs() / rates.times.scan_s;
  std::uint64_t below_beta = 0;
  const double plain_pairs = scene.pairs() * double(scene.some_models.size()) / double(scene.shapes);
  rates.plain = plain_pairs / plain_s(scene, below_beta);
  rates.below_beta = double(below_beta) / plain_pairs;
  const DevicePeak peak = measure_device_peak(setting.devices, setting.quick);
  rates.float_limit = peak.float_steps_per_s / rates.elements;
  rates.byte_limit = peak.byte_steps_per_s / rates.elements;
  rates.memory_limit = peak.read_bytes_per_s / rates.elements;
  return rates;
}

std::string table_text(const PairRates& rates) {
  TextTable table({"PAD pair tests", "pairs/s", "a core and s", "scan / this"});
  const auto row = [&](const std::string& name, double rate, int cores) {
    table.add({name, short_number(rate), short_number(rate / cores), short_number(rates.device / rate)});
  };
  row("device, by the index", rates.index, rates.cores);
  row("device, a scan of all PADs", rates.device, rates.cores);
  row("plain C++ loop, one thread", rates.plain, 1);
  row("limit: 4-byte elements", rates.float_limit, rates.cores);
  row("limit: 1-byte elements", rates.byte_limit, rates.cores);
  row("limit: every pair from memory", rates.memory_limit, rates.cores);
  return table.text();
}

std::string explanation(const PairScene& scene, const PairRates& rates) {
  const std::string elements = std::to_string(rates.elements);
  const DeviceTimes& times = rates.times;
  return "The best " + std::to_string(scene.wanted()) + " pairs of each of " + std::to_string(scene.samples.size()) +
         " target samples, " + std::to_string(scene.shapes) + " " + scene.kind + ": " + fixed(1000 * times.index_s, 1) +
         " ms by the index, " + fixed(1000 * times.scan_s, 1) +
         " ms by a scan,\nwhich is told how far to look. Blocks of " + std::to_string(kIndexFanOut) +
         " PADs looked at, to find the same pairs: " +
         fixed(100 * double(times.index_blocks) / double(std::max<std::uint64_t>(1, times.scan_blocks)), 2) + " %.\n" +
         short_number(scene.pairs()) + " pairs (" + short_number(100 * rates.below_beta) + " % nearer than beta), " +
         std::to_string(rates.cores) + " cores. Selection (scale, sign, local minima, " +
         "histogram) is in the device's\ntimes and in no limit; pairs that are skipped count as tested. Counted: " +
         elements + " elements a pair, each a\nsubtraction, a magnitude and a maximum (" +
         std::to_string(3 * rates.elements) + " operations); the limits are such steps a second, measured\n" +
         "in registers, over " + elements + ". From memory: 1 byte an element, " + elements +
         " bytes a pair, as if no target sample shared what\nanother had read.\n";
}

Json to_json(const PairScene& scene, const PairRates& rates) {
  return {{"cores", rates.cores},
          {"target_samples", scene.samples.size()},
          {"shapes", scene.shapes},
          {"pairs_wanted", scene.wanted()},
          {"index_s", rates.times.index_s},
          {"scan_s", rates.times.scan_s},
          {"index_blocks", rates.times.index_blocks},
          {"scan_blocks", rates.times.scan_blocks},
          {"pairs", scene.pairs()},
          {"below_beta_percent", rounded(100 * rates.below_beta)},
          {"index_pairs_per_s", rates.index},
          {"device_pairs_per_s", rates.device},
          {"device_pairs_per_core_s", rates.device / rates.cores},
          {"plain_pairs_per_s", rates.plain},
          {"elements_per_pair", rates.elements},
          {"operations_per_pair", 3 * rates.elements},
          {"bytes_per_pair", rates.elements},
          {"limit_float_pairs_per_s", rates.float_limit},
          {"limit_byte_pairs_per_s", rates.byte_limit},
          {"limit_memory_pairs_per_s", rates.memory_limit}};
}

}  // namespace

Report bench_pairs(const Setting& setting, const PairsOptions& options) {
  const PairScene scene = make_scene(options, setting.quick);
  const PairRates rates = measure(scene, setting);
  Report report{table_text(rates) + "\n" + explanation(scene, rates), report_head("pairs", setting)};
  report.json.update(to_json(scene, rates));
  return report;
}

}  // namespace tessera::bench
