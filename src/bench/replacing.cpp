#include "master/replacing.h"

#include <algorithm>
#include <cmath>

#include "bench/benchmarks.h"
#include "bench/devices.h"
#include "bench/inputs/library_matcher.h"
#include "bench/replacing_case.h"
#include "comm/encode.h"
#include "comm/messages.h"
#include "core/base/error.h"
#include "core/base/stopwatch.h"
#include "core/replacing/own_replacer.h"
#include "library/library_shapes.h"
#include "library/storage/library_file.h"
#include "master/collage_loop.h"
#include "text/number_text.h"
#include "text/text_table.h"

namespace tessera::bench {
namespace {

constexpr int kLargestTile_px = 1000;
constexpr int kBreadth = 1 << 20;  // more than there are windows: a batch is one request
constexpr std::size_t kTriedWindows = 40;

/// Measures each window, and runs the trials of some.
class MeasuringReplacer : public Replacer {
 public:
  explicit MeasuringReplacer(ShapeSource& shapes) : own_(shapes, 1, [] {}) {}

  int breadth() const override { return kBreadth; }

  void post_replace(std::vector<ReplacementWindow> windows) override {
    before_s = watch_.seconds();
    posted_ = std::move(windows);
  }

  std::vector<ReplacementOutcome> take_replaced() override {
    read_shapes();
    const std::size_t stride = (posted_.size() + kTriedWindows - 1) / kTriedWindows;
    std::vector<ReplacementOutcome> outcomes;
    for (std::size_t i = 0; i < posted_.size(); ++i) outcomes.push_back(measured(posted_[i], i % stride == 0));
    estimate_others();
    const double windows = double(posted_.size());
    for (double* each_s : {&found.request_s, &found.unpack_s, &found.reply_s}) *each_s /= windows;
    watch_.lap();
    return outcomes;
  }

  /// Seconds since the replacer was made, or since its last answer.
  double since_s() const { return watch_.seconds(); }

  ReplacingCase found;
  double before_s = 0;

 private:
  ReplacementOutcome measured(const ReplacementWindow& window, bool tried) {
    MeasuredWindow measure{.trials = window.trials};
    Stopwatch watch;
    const comm::Bytes request = comm::encode(std::vector<ReplacementWindow>{window});
    found.request_s += watch.lap();
    const auto question = comm::decode<std::vector<ReplacementWindow>>(request);
    found.unpack_s += watch.lap();
    const std::vector<ReplacementOutcome> outcome{tried ? tried_on_this_core(question) : as_it_was(window)};
    if (tried) measure.work_s = watch.seconds();
    watch.lap();
    const comm::Bytes reply = comm::encode(outcome);
    found.reply_s += watch.seconds();
    measure.request_bytes = double(request.size());
    measure.reply_bytes = double(reply.size());
    found.windows.push_back(measure);
    return outcome[0];
  }

  ReplacementOutcome tried_on_this_core(const std::vector<ReplacementWindow>& question) {
    own_.post_replace(question);
    return own_.take_replaced().at(0);
  }

  static ReplacementOutcome as_it_was(const ReplacementWindow& window) {
    ReplacementOutcome outcome;
    for (std::uint32_t i = 0; i < window.moving.size(); ++i) {
      outcome.pieces.push_back({window.moving[i].shape, window.moving[i].canvas_from_shape, i});
    }
    return outcome;
  }

  /// Reads the shapes, which a worker does only once.
  void read_shapes() {
    ReplacementWindow window = posted_.front();
    window.trials = 0;
    tried_on_this_core({window});
  }

  /// Estimates the work of the other windows: each of their trials takes the mean time of those that were run.
  void estimate_others() {
    double tried = 0;
    for (const MeasuredWindow& w : found.windows) tried += w.work_s > 0 ? w.trials : 0;
    const double trial_s = found.work_s() / std::max(1., tried);
    for (MeasuredWindow& w : found.windows) {
      if (w.work_s == 0) w.work_s = trial_s * w.trials;
    }
  }

  OwnReplacer own_;
  Stopwatch watch_;
  std::vector<ReplacementWindow> posted_;
};

/// A seamless collage, repeated until it fills the canvas. A batch on it is like one on a large collage, which would
/// take an hour to fill.
std::vector<Placement> tiled_collage(const LibraryFile& library, ShapeSource& shapes, CollageSettings settings,
                                     int size_px, const std::string& devices) {
  const int tiles = (size_px + kLargestTile_px - 1) / kLargestTile_px;
  const int tile_px = size_px / tiles;
  settings.improve.trials = 1;
  const auto matcher = library_matcher(library, library.size(), settings, devices);
  master::SilentObserver silent;
  const Canvas tile = make_seamless_canvas(tile_px, tile_px, true, true);
  const master::CollageResult made = master::make_collage(tile, settings, *matcher, shapes, silent);
  std::vector<Placement> all;
  for (int j = 0; j < tiles; ++j) {
    for (int i = 0; i < tiles; ++i) {
      for (Placement p : made.placements) {
        p.canvas_from_shape = moved(p.canvas_from_shape, Vec2{float(i * tile_px), float(j * tile_px)});
        all.push_back(p);
      }
    }
  }
  return all;
}

ReplacingCase measured_batch(const Canvas& canvas, const CollageSettings& settings, std::vector<Placement> pieces,
                             ShapeSource& shapes, std::uint32_t library_shapes) {
  const FreeField free(canvas, settings.pieces);
  const StanceTable stances(settings, library_shapes);
  const PoseRange poses{settings.pieces.min_scale_px, settings.pieces.max_scale_px, {}};
  MeasuringReplacer replacer(shapes);
  master::ReplacementProgress progress{0, 20 * pieces.size()};
  master::Replacing replacing(
      free, stances, settings, canvas.area_px2, shapes, [&](const Placement&) { return poses; }, replacer);
  const double began_s = replacer.since_s();
  replacing.batch(pieces, 0, progress);
  if (replacer.found.windows.empty()) {
    throw InputError("--size: found " + std::to_string(canvas.width_px) +
                     " px, on which no piece may move; allowed: several times the largest piece");
  }
  replacer.found.master_s = replacer.before_s - began_s + replacer.since_s();
  replacer.found.canvas_px = canvas.width_px;
  replacer.found.pieces = pieces.size();
  return replacer.found;
}

std::string text_of(const ReplacingCase& c) {
  TextTable table({"a batch of replacement trials", ""});
  double request_bytes = 0, reply_bytes = 0;
  for (const MeasuredWindow& w : c.windows) {
    request_bytes += w.request_bytes;
    reply_bytes += w.reply_bytes;
  }
  const auto windows = double(c.windows.size());
  table.add({"canvas", std::to_string(c.canvas_px) + " x " + std::to_string(c.canvas_px) + " px"});
  table.add({"pieces", std::to_string(c.pieces)});
  table.add({"windows", std::to_string(c.windows.size())});
  table.add({"trials", std::to_string(c.trials())});
  table.add({"a trial, one core", fixed(1000 * c.work_s() / double(c.trials()), 2) + " ms"});
  table.add({"all trials, one core", fixed(c.work_s(), 2) + " s"});
  table.add({"master's own work", fixed(1000 * c.master_s, 1) + " ms"});
  table.add({"a question, packed",
             fixed(1000 * c.request_s, 3) + " ms, " + fixed(request_bytes / windows / 1000, 1) + " kB a window"});
  table.add({"a question, unpacked", fixed(1000 * c.unpack_s, 3) + " ms a window"});
  table.add({"an answer, packed",
             fixed(1000 * c.reply_s, 3) + " ms, " + fixed(reply_bytes / windows / 1000, 1) + " kB a window"});
  return table.text();
}

}  // namespace

Report bench_replacing(const Setting& setting, const SquareJob& job) {
  check(job);
  const LibraryFile library(job.library);
  const int size_px = setting.quick ? std::min(job.size_px, 300) : job.size_px;
  CollageSettings settings;
  settings.seed = job.seed;
  settings.pieces.min_scale_px = job.scale_px[0];
  settings.pieces.max_scale_px = job.scale_px[1];
  LibraryShapes shapes(library);
  const std::vector<Placement> pieces = tiled_collage(library, shapes, settings, size_px, setting.devices);
  const ReplacingCase found =
      measured_batch(make_rectangle_canvas(size_px, size_px), settings, pieces, shapes, std::uint32_t(library.size()));
  Report report;
  report.json = report_head("replacing", setting);
  report.json.update({{"library", job.library},
                      {"shapes", library.size()},
                      {"scale_px", job.scale_px},
                      {"seed", job.seed},
                      {"batch", to_json(found)}});
  report.text = text_of(found) + "\n" + std::to_string(std::min(found.windows.size(), kTriedWindows)) +
                " windows were tried, or a few more or less; the others are counted as them. " +
                "replacing_sim plays the batch on more hosts.\n";
  return report;
}

}  // namespace tessera::bench
