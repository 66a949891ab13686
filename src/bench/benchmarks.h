// tessera bench NAME: each benchmark measures one claim and gives a table for people with the same figures as JSON.
// One file for each. All throw InputError and EnvironmentError.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "bench/blocking/silhouette_options.h"
#include "bench/report.h"

namespace tessera::bench {

/// What all benchmarks take.
struct Setting {
  bool quick = false;           // a small version, which only shows that it runs
  std::string devices = "all";  // as the job key devices.use
  std::string out;              // the JSON file; what else a benchmark writes has its name with other endings
  /// Told a line at the beginning of each part of a long benchmark.
  std::function<void(const std::string&)> progress = [](const std::string&) {};
};

struct PairsOptions {
  std::string library;       // empty: blobs
  std::uint32_t shapes = 0;  // 0: the library's, or 1,000 blobs
};
/// The pairs of a few hundred target samples, by the index and by a scan of all PADs; pair tests per second and core,
/// and what the machine can do at most.
Report bench_pairs(const Setting& setting, const PairsOptions& options);

/// Measures the way from PADs to the best docking of two shapes with 25,000,000 docking positions (paper, section 5).
Report bench_headline(const Setting& setting);

struct Table2Options {
  std::string library;
  std::vector<std::string> rows;  // names of table2_rows(); empty = all
};
/// Jobs of the sizes of the paper's Table 2.
Report bench_table2(const Setting& setting, const Table2Options& options);

/// On a square canvas.
struct SquareJob {
  std::string library;
  std::array<float, 2> scale_px = {20, 160};
  int size_px = 1000;
  std::uint64_t seed = 1;
};
void check(const SquareJob& job);

/// This engine beside what could be done instead, on one job.
Report bench_alternatives(const Setting& setting, const SquareJob& job);

/// What longer improving brings, with and without pieces that move together: after 1, 2, 4 s and so on, and `seconds`.
/// Also writes a plot.
Report bench_quality(const Setting& setting, const SquareJob& job, int seconds);

/// One batch of replacement trials on a large canvas: the master's part of it, and the workers'.
Report bench_replacing(const Setting& setting, const SquareJob& job);

struct LibraryOptions {
  std::string library;
  std::vector<std::uint32_t> sizes;  // none: 100 to 100,000, or two small ones where it is quick
  std::string models;  // folder where models are kept and read from (model_file.h); empty: they are held in memory
};
/// Time and memory as the library grows.
Report bench_library(const Setting& setting, const LibraryOptions& options);

struct VarietyOptions {
  std::vector<std::uint32_t> sizes;  // none: 100 to 10,000, or two small ones where it is quick
  /// Docked for a target sample; 0: random dockings alone. None: 0 to 400, or two of them where it is quick.
  std::vector<std::uint32_t> pairs;
  std::optional<int> seeds;  // 4, or 1 where it is quick
  std::string models;        // as in LibraryOptions
};
/// What more shapes, and more pairs docked, bring to a collage.
Report bench_variety(const Setting& setting, const SquareJob& job, const VarietyOptions& options);

struct MosaicOptions {
  std::string library;
  std::vector<std::string> images;    // as tessera mosaic takes them
  int pieces = 2000;                  // that tessera mosaic is asked for; the peer gets as many tiles as it lays
  std::vector<std::string> grounds;   // "#rrggbb", of the peer's tiles; none: a light and a dark one
  std::vector<std::string> settings;  // "KEY=VALUE" of our jobs
  std::string program;                // tessera itself
};
/// Mosaics of images beside those that metapixel makes of the same drawings: how well they show the images from afar.
/// The pictures lie in the folder of the report's name; also writes CSV. Without metapixel ours alone are measured.
Report bench_mosaic(const Setting& setting, const MosaicOptions& options);

struct BlockingOptions : SilhouetteOptions {
  std::vector<int> blocks;               // percent of the box's width that is hidden; none: 0, 10, .. 90
  std::vector<std::string> descriptors;  // "pad", or a name of all_descriptors(); none: "pad"
};
/// How often silhouettes are recognised by what is left of them when their left part is hidden (paper, Figs. 26 and 27).
/// Also writes a plot.
Report bench_blocking(const Setting& setting, const BlockingOptions& options);

struct DescriptorsOptions {
  std::string shapes = {};  // folder of silhouettes, of which one of each class; empty: blobs made from formulas
  std::optional<double> minutes = {};  // of processor time, for each method; 1, or 0.05 where it is quick
  int pieces = 0;                      // a method stops after so many; 0: no limit
};
/// The same collage with PADs, and with other descriptors that are extended naively to parts of shapes: how many pieces
/// each places in the same time (paper, Fig. 28). Also writes a plot, and a picture of each collage.
Report bench_descriptors(const Setting& setting, const DescriptorsOptions& options);

struct ScenesOptions : SilhouetteOptions {
  /// The scale is unknown by default: a scene of two silhouettes does not tell it.
  ScenesOptions() { scale_known = false; }

  std::vector<std::string> kinds;  // names of scene_kinds(); none: all
  std::vector<int> hidden;         // percent of the silhouette's area, or of its boundary; none: 20, 30, .. 70
  std::string left_out = "none";   // of the library: "classes" or "shapes", half of them
};
/// How often silhouettes are recognised that lie below others or behind branches, or of which a part was changed (paper,
/// Fig. 4); and, where some are not in the library, precision and recall against the least score and similarity of an answer. Also
/// writes a plot.
Report bench_scenes(const Setting& setting, const ScenesOptions& options);

struct ScalingOptions {
  std::string library;
  std::uint32_t shapes = 0;         // for the most workers; beyond the library's, varied ones; 0 = the library's
  std::vector<int> ranks = {2, 3};  // one of them the master
  int pieces = 20;
  int size_px = 600;  // of the square canvas
  int repeats = 3;
  /// What "-n RANKS PROGRAM..." is appended to.
  std::string launcher = "mpirun -x POCL_MAX_PTHREAD_COUNT --oversubscribe --bind-to none";
  std::string program;  // tessera itself
};
/// Strong and weak scaling over the workers, a core each, beside Amdahl's law; also writes CSV and a plot.
Report bench_scaling(const Setting& setting, const ScalingOptions& options);

struct ConceptsOptions {
  std::string library;
  std::string folder;      // where the figures are written
  std::string shape = {};  // whose PAD is shown; empty: the first one
  std::string devices = "all";
};
/// Draws the figures of docs/concepts, each of one stage of the pipeline: shapes.svg, target.svg and so on. Their bytes are
/// the same on every machine.
void draw_concepts(const ConceptsOptions& options);

}  // namespace tessera::bench
