#include <algorithm>

#include "bench/benchmarks.h"
#include "bench/device_peak.h"
#include "bench/devices.h"
#include "bench/formula_shapes.h"
#include "bench/library_matcher.h"
#include "bench/timing.h"
#include "core/free_field.h"
#include "core/matcher.h"
#include "core/target_curve.h"
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
  for (const std::uint32_t edge : curve.sample_edges()) {
    if (scene.samples.size() < samples) scene.samples.push_back(curve.sample(edge));
  }
  return scene;
}

/// In another order each time: a device does not count twice for the same samples.
double device_s(const PairScene& scene, const Setting& setting, int runs) {
  const auto matcher = worker::make_device_matcher(setting.devices, scene.context, 0, scene.models);
  matcher->start_field(scene.field.value.width(), scene.field.value.height(), scene.field.origin);
  matcher->update_field(read_patch(scene.field.value, scene.field.value.bounds()));
  std::vector<TargetSample> samples = scene.samples;
  return median_s(runs, [&] {
    std::rotate(samples.begin(), samples.begin() + 1, samples.end());
    matcher->post_count(samples);
    matcher->take_count();
  });
}

/// Equation 1 for every pair, nothing else.
double plain_s(const PairScene& scene, int runs, std::uint64_t& below_beta) {
  const int levels = scene.context.pad.levels;
  return median_s(runs, [&] {
    below_beta = 0;
    for (const TargetSample& sample : scene.samples) {
      const Pad target = make_pad(sample.pyramid, levels);
      for (const ShapeModel& model : scene.models) {
        for (const ModelLevel& level : model.levels) {
          for (const Pad& pad : level.pads) below_beta += pad_distance(target, pad, levels) < scene.context.beta;
        }
      }
    }
  });
}

}  // namespace

Report bench_pairs(const Setting& setting) {
  const PairScene scene = setting.quick ? make_scene(20, 100, 300) : make_scene(1000, 1000, 1000);
  const int runs = setting.quick ? 2 : 5;
  const int elements = 2 * (scene.context.pad.levels - 1);
  const int units = compute_units(setting.devices);
  std::uint64_t below_beta = 0;  // of the pairs, whatever their scale
  const double device = scene.pairs() / device_s(scene, setting, runs);
  const double plain = scene.pairs() / plain_s(scene, 1, below_beta);
  const DevicePeak peak = measure_device_peak(setting.devices, setting.quick);
  const double float_limit = peak.float_steps_per_s / elements;
  const double byte_limit = peak.byte_steps_per_s / elements;
  const double memory_limit = peak.read_bytes_per_s / elements;

  Table table({"PAD pair tests", "pairs/s", "a core and s", "device / this"});
  const auto row = [&](const std::string& name, double rate, int cores) {
    table.add({name, short_number(rate), short_number(rate / cores), short_number(device / rate)});
  };
  row("device, selection included", device, units);
  row("plain C++ loop, one thread", plain, 1);
  row("limit: 4-byte elements", float_limit, units);
  row("limit: 1-byte elements", byte_limit, units);
  row("limit: every pair from memory", memory_limit, units);

  Report report;
  report.text =
      table.text() + "\n" + std::to_string(scene.samples.size()) + " target samples, " +
      std::to_string(scene.models.size()) + " blobs, " + short_number(scene.pairs()) + " pairs (" +
      short_number(100 * double(below_beta) / scene.pairs()) + " % nearer than beta), " + std::to_string(units) +
      " cores.\nCounted: " + std::to_string(elements) +
      " elements a pair, each a subtraction, a magnitude and a maximum (" + std::to_string(3 * elements) +
      " operations);\nthe limits are such steps a second, measured in registers, over " + std::to_string(elements) +
      ". From memory: 1 byte an element, " + std::to_string(elements) +
      " bytes a pair,\nas if no target sample shared what another had read. Selection (scale, sign, local minima, "
      "histogram)\nis in the device's time and in no limit; pairs that it skips count as tested.\n";
  report.json = {{"benchmark", "pairs"},
                 {"quick", setting.quick},
                 {"devices", device_names(setting.devices)},
                 {"cores", units},
                 {"target_samples", scene.samples.size()},
                 {"shapes", scene.models.size()},
                 {"pairs", scene.pairs()},
                 {"runs", runs},
                 {"device_pairs_per_s", device},
                 {"device_pairs_per_core_s", device / units},
                 {"plain_pairs_per_s", plain},
                 {"plain_pairs_below_beta", below_beta},
                 {"elements_per_pair", elements},
                 {"operations_per_pair", 3 * elements},
                 {"bytes_per_pair", elements},
                 {"limit_float_pairs_per_s", float_limit},
                 {"limit_byte_pairs_per_s", byte_limit},
                 {"limit_memory_pairs_per_s", memory_limit},
                 {"read_bytes_per_s", peak.read_bytes_per_s}};
  return report;
}

}  // namespace tessera::bench
