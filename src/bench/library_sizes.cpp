#include <algorithm>
#include <optional>
#include <unordered_map>

#include "bench/benchmarks.h"
#include "bench/devices.h"
#include "bench/inputs/library_matcher.h"
#include "bench/inputs/model_file.h"
#include "bench/inputs/varied_shapes.h"
#include "bench/process_memory.h"
#include "core/base/stop.h"
#include "core/base/stopwatch.h"
#include "master/collage_loop.h"
#include "text/number_text.h"
#include "text/text_table.h"
#include "worker/device_group.h"
#include "worker/shard/shard.h"

namespace tessera::bench {
namespace {

struct Grown {
  RunStatistics statistics;
  std::size_t pieces = 0;
  double start_s = 0;        // until the matcher is ready
  double first_piece_s = 0;  // from the start, without the making of shapes
  std::uint64_t peak_bytes = 0;
  std::uint64_t device_bytes = 0;
};

/// Keeps every shape, so that asking for it again takes no time.
class KeptShapes : public ShapeSource {
 public:
  explicit KeptShapes(ShapeSource& shapes) : shapes_(shapes) {}

  const Shape& shape(ShapeId id) override {
    const auto place = kept_.find(id);
    return place != kept_.end() ? place->second : kept_.emplace(id, shapes_.shape(id)).first->second;
  }
  const ShapeModel& model(ShapeId id) override { return shapes_.model(id); }

 private:
  ShapeSource& shapes_;
  std::unordered_map<ShapeId, Shape> kept_;
};

/// Notes the time when the first piece is placed.
class FirstPiece : public master::Observer {
 public:
  explicit FirstPiece(const VariedShapes& shapes) : shapes_(shapes) {}

  void progressed(const master::Progress& progress) override {
    if (!seconds_ && progress.pieces > 0) seconds_ = watch_.seconds() - shapes_.making_s();
  }
  std::optional<StopReason> stop_requested() override { return std::nullopt; }
  double seconds() const { return seconds_.value_or(0); }

 private:
  const VariedShapes& shapes_;
  Stopwatch watch_;
  std::optional<double> seconds_;
};

Grown run_size(const LibraryFile& library, std::uint32_t count, const Canvas& canvas, const CollageSettings& settings,
               const std::string& devices_use, const std::string& folder) {
  VariedShapes shapes(library);
  const MatchingContext context = make_matching_context(settings, count);
  const std::shared_ptr<const ModelSource> models = varied_models(shapes, count, context, folder);
  reset_peak_memory();
  Grown grown;
  const Stopwatch watch;
  const auto matcher = worker::make_device_matcher(devices_use, context, {0, count}, models);
  grown.start_s = watch.seconds();
  KeptShapes kept(shapes);
  FirstPiece first(shapes);
  master::make_collage(canvas, settings, *matcher, kept, first);
  grown.first_piece_s = grown.start_s + first.seconds();
  // The run is repeated: making shapes takes as long as much of a round, while the device works.
  master::SilentObserver silent;
  const master::CollageResult result = master::make_collage(canvas, settings, *matcher, kept, silent);
  grown.statistics = result.statistics;
  grown.pieces = result.placements.size();
  grown.peak_bytes = peak_memory_bytes();
  grown.device_bytes = worker::shard_bytes(context, count, models->supports_random_access()).device;
  return grown;
}

std::vector<std::uint32_t> chosen_sizes(std::vector<std::uint32_t> sizes, bool quick) {
  if (sizes.empty())
    return quick ? std::vector<std::uint32_t>{10, 30} : std::vector<std::uint32_t>{100, 1000, 10000, 100000};
  check_varied_sizes(sizes);
  std::sort(sizes.begin(), sizes.end());
  return sizes;
}

void add_size(TextTable& table, Json& sizes, std::uint32_t size, const Grown& grown) {
  const RunStatistics& s = grown.statistics;
  const double pieces = double(std::max<std::size_t>(1, grown.pieces));
  const double master_s = s.objective_s + s.merge_s;
  const auto ms = [&](double seconds) { return fixed(1000 * seconds / pieces, 1); };
  const auto megabytes = [](std::uint64_t bytes) { return fixed(double(bytes) / 1e6, 0); };
  table.add({std::to_string(size), std::to_string(grown.pieces), std::to_string(s.rounds), ms(s.total_s), ms(s.prune_s),
             ms(s.dock_s), ms(master_s), fixed(grown.start_s, 1), fixed(grown.first_piece_s, 1),
             megabytes(grown.peak_bytes), megabytes(grown.device_bytes)});
  sizes.push_back({{"shapes", size},
                   {"pieces", grown.pieces},
                   {"rounds", s.rounds},
                   {"target_samples", s.target_samples},
                   {"s_per_piece", s.total_s / pieces},
                   {"prune_s", rounded(s.prune_s)},
                   {"dock_s", rounded(s.dock_s)},
                   {"master_s", rounded(master_s)},
                   {"start_s", rounded(grown.start_s)},
                   {"first_piece_s", rounded(grown.first_piece_s)},
                   {"peak_memory_bytes", grown.peak_bytes},
                   {"device_bytes", grown.device_bytes}});
}

std::string explanation(int pieces, int size_px, std::size_t originals) {
  return "Up to " + std::to_string(pieces) + " pieces on " + std::to_string(size_px) + " x " + std::to_string(size_px) +
         " px, with the first matching of the whole canvas, laid a second time. Shapes beyond\n"
         "the file's " +
         std::to_string(originals) +
         " are mirrored and stretched ones, made the first time. First piece: from the start on. Device: the\n"
         "shard's buffers; on a CPU device they count in the peak memory too.\n";
}

}  // namespace

Report bench_library(const Setting& setting, const LibraryOptions& options) {
  const std::vector<std::uint32_t> sizes = chosen_sizes(options.sizes, setting.quick);
  const LibraryFile library(options.library);
  const int size_px = setting.quick ? 200 : options.size_px;
  const Canvas canvas = make_rectangle_canvas(size_px, size_px);
  CollageSettings settings;
  settings.stop.pieces = setting.quick ? 3 : options.pieces;

  TextTable table({"shapes", "pieces", "rounds", "ms a piece", "prune", "dock", "objective, merge", "start s",
                   "first piece s", "peak memory MB", "device MB"});
  Report report;
  report.json = report_head("library", setting);
  report.json.update({{"library", options.library},
                      {"originals", library.size()},
                      {"canvas_px", size_px},
                      {"pieces", settings.stop.pieces},
                      {"sizes", Json::array()}});
  for (const std::uint32_t size : sizes) {
    setting.progress(std::to_string(size) + " shapes");
    add_size(table, report.json["sizes"], size,
             run_size(library, size, canvas, settings, setting.devices, options.models));
  }
  report.text = table.text() + "\n" + explanation(settings.stop.pieces, size_px, library.size());
  return report;
}

}  // namespace tessera::bench
