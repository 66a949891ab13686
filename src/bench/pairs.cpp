#include <algorithm>

#include "bench/benchmarks.h"
#include "bench/device_peak.h"
#include "bench/devices.h"
#include "bench/formula_shapes.h"
#include "bench/timing.h"
#include "core/field/free_field.h"
#include "core/field/target_curve.h"
#include "core/matching/match_round.h"
#include "io/text_table.h"
#include "worker/device_group.h"

namespace tessera::bench {
namespace {

/// Blobs against the free region that is left when some of them lie in a grid on the canvas.
struct PairScene {
  CollageSettings settings;
  std::vector<TargetSample> samples;
  MatchingContext context;
  std::vector<ShapeModel> models;
  double pads = 0;  // of the library
  CanvasField field;

  double pairs() const { return double(samples.size()) * pads; }
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

PairScene make_scene(std::size_t shapes, std::size_t samples, int size_px) {
  PairScene scene;
  const std::vector<Shape> library = blob_shapes(shapes);
  scene.context = make_matching_context(scene.settings, std::uint32_t(shapes));
  scene.models = models_of(library, scene.context);
  scene.pads = double(pads_per_shape(scene.context) * shapes);
  FreeField free(make_rectangle_canvas(size_px, size_px), scene.settings.pieces);
  lay_grid(free, library, size_px);
  scene.field = free.field();
  const OpenedField opened(free, scene.settings.pieces);
  TargetCurve curve(scene.settings.pieces, scene.settings.match.pad);
  curve.retrace(opened, free.field().origin, free.field().value.bounds());
  for (const SampleId id : curve.samples()) {
    if (scene.samples.size() < samples) scene.samples.push_back(curve.sample(id));
  }
  return scene;
}

/// In another order each time: a device does not count twice for the same samples.
double device_s(const PairScene& scene, const std::string& devices_use, int runs) {
  const auto matcher =
      worker::make_device_matcher(devices_use, scene.context, all_of(scene.models), given(scene.models));
  matcher->start_field(scene.field.value.width(), scene.field.value.height(), scene.field.origin);
  matcher->update_field(read_patch(scene.field.value, scene.field.value.bounds()));
  CountRequest request{scene.samples,
                       match_plan(scene.settings.match, std::uint64_t(scene.pads)).pairs_per_sample};
  return median_s(runs, [&] {
    std::rotate(request.samples.begin(), request.samples.begin() + 1, request.samples.end());
    matcher->post_count(request);
    matcher->take_count();
  });
}

/// Equation 1 for every pair, nothing else.
double plain_s(const PairScene& scene, std::uint64_t& below_beta) {
  const int levels = scene.context.pad.levels;
  return median_s(1, [&] {
    below_beta = 0;
    for (const TargetSample& sample : scene.samples) {
      const QuantisedPad target = quantised(make_pad(sample.pyramid, levels));
      for (const ShapeModel& model : scene.models) {
        for (const ModelLevel& level : model.levels) {
          for (const ModelSample& source : level.samples) {
            below_beta += pad_distance(target, source.pad, levels) < scene.context.beta_steps;
          }
        }
      }
    }
  });
}

/// Pairs a second.
struct PairRates {
  int cores = 0;
  int elements = 0;  // of a PAD
  double device = 0;
  double plain = 0;
  double float_limit = 0;
  double byte_limit = 0;
  double memory_limit = 0;
  double below_beta = 0;  // part of the pairs, whatever their scale
};

PairRates measure(const PairScene& scene, const Setting& setting) {
  PairRates rates;
  rates.cores = compute_units(setting.devices);
  rates.elements = 2 * (scene.context.pad.levels - 1);
  rates.device = scene.pairs() / device_s(scene, setting.devices, setting.quick ? 2 : 5);
  std::uint64_t below_beta = 0;
  rates.plain = scene.pairs() / plain_s(scene, below_beta);
  rates.below_beta = double(below_beta) / scene.pairs();
  const DevicePeak peak = measure_device_peak(setting.devices, setting.quick);
  rates.float_limit = peak.float_steps_per_s / rates.elements;
  rates.byte_limit = peak.byte_steps_per_s / rates.elements;
  rates.memory_limit = peak.read_bytes_per_s / rates.elements;
  return rates;
}

std::string table_text(const PairRates& rates) {
  io::TextTable table({"PAD pair tests", "pairs/s", "a core and s", "device / this"});
  const auto row = [&](const std::string& name, double rate, int cores) {
    table.add({name, short_number(rate), short_number(rate / cores), short_number(rates.device / rate)});
  };
  row("device, selection included", rates.device, rates.cores);
  row("plain C++ loop, one thread", rates.plain, 1);
  row("limit: 4-byte elements", rates.float_limit, rates.cores);
  row("limit: 1-byte elements", rates.byte_limit, rates.cores);
  row("limit: every pair from memory", rates.memory_limit, rates.cores);
  return table.text();
}

std::string explanation(const PairScene& scene, const PairRates& rates) {
  const std::string elements = std::to_string(rates.elements);
  return std::to_string(scene.samples.size()) + " target samples, " + std::to_string(scene.models.size()) + " blobs, " +
         short_number(scene.pairs()) + " pairs (" + short_number(100 * rates.below_beta) + " % nearer than beta), " +
         std::to_string(rates.cores) + " cores.\nCounted: " + elements +
         " elements a pair, each a subtraction, a magnitude and a maximum (" + std::to_string(3 * rates.elements) +
         " operations);\nthe limits are such steps a second, measured in registers, over " + elements +
         ". From memory: 1 byte an element, " + elements +
         " bytes a pair,\nas if no target sample shared what another had read. Selection (scale, sign, local minima, "
         "histogram)\nis in the device's time and in no limit; pairs that it skips count as tested. It looks as far as "
         "most\nsamples need for their most_pairs best.\n";
}

Json to_json(const PairScene& scene, const PairRates& rates) {
  return {{"cores", rates.cores},
          {"target_samples", scene.samples.size()},
          {"shapes", scene.models.size()},
          {"pairs", scene.pairs()},
          {"below_beta_percent", rounded(100 * rates.below_beta)},
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

Report bench_pairs(const Setting& setting) {
  const PairScene scene = setting.quick ? make_scene(20, 100, 300) : make_scene(1000, 1000, 1000);
  const PairRates rates = measure(scene, setting);
  Report report{table_text(rates) + "\n" + explanation(scene, rates), report_head("pairs", setting)};
  report.json.update(to_json(scene, rates));
  return report;
}

}  // namespace tessera::bench
