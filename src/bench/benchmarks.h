// tessera bench NAME: each benchmark measures one claim and gives a table for people with the same figures as JSON.
// Each has a file of its own. All throw InputError and EnvironmentError.
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

/// The settings of all benchmarks.
struct Setting {
  bool quick = false;           // true: a small version, which only shows that it runs
  std::string devices = "all";  // as the job key devices.use
  std::string out;              // the JSON file; a benchmark's other files have this name with other endings
  /// Called with one line at the beginning of each part of a long benchmark.
  std::function<void(const std::string&)> progress = [](const std::string&) {};
};

struct PairsOptions {
  std::string library;       // empty: blobs made from formulas
  std::uint32_t shapes = 0;  // 0: all shapes of the library, or 1,000 blobs
};
/// Finds the pairs of some hundred target samples, with the index and with a scan of all PADs. Reports pair tests for
/// each second and core, and the most that the machine can do.
Report bench_pairs(const Setting& setting, const PairsOptions& options);

/// Measures the time from PADs to the best docking of two shapes with 25,000,000 docking positions (paper, section 5).
Report bench_headline(const Setting& setting);

struct Table2Options {
  std::string library;
  std::vector<std::string> rows;  // names of table2_rows(); empty = all
};
/// Runs jobs of the sizes in the paper's Table 2.
Report bench_table2(const Setting& setting, const Table2Options& options);

/// A job on a square canvas.
struct SquareJob {
  std::string library;
  std::array<float, 2> scale_px = {20, 160};
  int size_px = 1000;
  std::uint64_t seed = 1;
};
void check(const SquareJob& job);

/// Compares this engine with other methods on one job.
Report bench_alternatives(const Setting& setting, const SquareJob& job);

/// Measures the gain from longer improving, with and without pieces that move together: after 1, 2, 4 s and so on, and
/// `seconds`. Also writes a plot.
Report bench_quality(const Setting& setting, const SquareJob& job, int seconds);

/// Measures one batch of replacement trials on a large canvas: the master's part and the workers' part.
Report bench_replacing(const Setting& setting, const SquareJob& job);

struct LibraryOptions {
  std::string library;
  std::vector<std::uint32_t> sizes;  // empty: 100 to 100,000; two small ones with --quick
  std::string models;                // folder that stores the models (model_file.h); empty: they are held in memory
  int pieces = 20;
  int size_px = 1000;  // of the square canvas
};
/// Measures time and memory for growing libraries.
Report bench_library(const Setting& setting, const LibraryOptions& options);

struct VarietyOptions {
  std::vector<std::uint32_t> sizes;  // empty: 100 to 10,000; two small ones with --quick
  /// Pairs docked for a target sample; 0: only random dockings. Empty: 0 to 400; two of them with --quick.
  std::vector<std::uint32_t> pairs;
  std::optional<int> seeds;  // nullopt: 4; 1 with --quick
  std::string models;        // as in LibraryOptions
};
/// Measures how a collage gains from more shapes and from more docked pairs.
Report bench_variety(const Setting& setting, const SquareJob& job, const VarietyOptions& options);

struct MosaicOptions {
  std::string library;
  std::vector<std::string> images;    // as for tessera mosaic
  int pieces = 2000;                  // asked of tessera mosaic; metapixel gets as many tiles as that lays
  std::vector<std::string> grounds;   // "#rrggbb", of metapixel's tiles; empty: a light and a dark one
  std::vector<std::string> settings;  // "KEY=VALUE" for our jobs
  std::string program;                // the tessera program
};
/// Compares our mosaics with those of metapixel from the same drawings: how well they show the images from afar. The
/// pictures go into the folder with the report's name; also writes CSV. Without metapixel only our mosaics are
/// measured.
Report bench_mosaic(const Setting& setting, const MosaicOptions& options);

struct BlockingOptions : SilhouetteOptions {
  std::vector<int> blocks;               // percent of the box's width that is hidden; empty: 0, 10, .. 90
  std::vector<std::string> descriptors;  // "pad", or names from all_descriptors(); empty: "pad"
};
/// Measures how often silhouettes are recognised when their left part is hidden (paper, Figs. 26 and 27). Also writes a
/// plot.
Report bench_blocking(const Setting& setting, const BlockingOptions& options);

struct DescriptorsOptions {
  std::string shapes = {};             // folder of silhouettes, one of each class is used; empty: blobs
  std::optional<double> minutes = {};  // processor time of each method; nullopt: 1, 0.05 with --quick
  int pieces = 0;                      // a method stops after this many; 0: no limit
};
/// Makes the same collage with PADs, and with other descriptors that are extended naively to parts of shapes. Reports
/// the pieces that each places in the same time (paper, Fig. 28). Also writes a plot, and a picture of each collage.
Report bench_descriptors(const Setting& setting, const DescriptorsOptions& options);

struct ScenesOptions : SilhouetteOptions {
  /// The scale is unknown by default: a scene of two silhouettes does not show it.
  ScenesOptions() { scale_known = false; }

  std::vector<std::string> kinds;  // names from scene_kinds(); empty: all
  std::vector<int> hidden;         // percent of the silhouette's area or boundary; empty: 20, 30, .. 70
  std::string left_out = "none";   // of the library: "classes" or "shapes" leaves out half of them
};
/// Measures how often silhouettes are recognised that lie below others or behind branches, or that were changed in part
/// (paper, Fig. 4). Where some are not in the library it also reports precision and recall for thresholds of score and
/// similarity. Also writes a plot.
Report bench_scenes(const Setting& setting, const ScenesOptions& options);

struct ScalingOptions {
  std::string library;
  std::uint32_t shapes = 0;         // for the most workers; beyond the library's: varied shapes; 0: the library's
  std::vector<int> ranks = {2, 3};  // one of them the master
  int pieces = 20;
  int size_px = 600;  // of the square canvas
  int repeats = 3;
  /// The command to which "-n RANKS PROGRAM..." is appended.
  std::string launcher = "mpirun -x POCL_MAX_PTHREAD_COUNT --oversubscribe --bind-to none";
  std::string program;  // the tessera program
};
/// Measures strong and weak scaling over the workers, one core each, beside Amdahl's law; also writes CSV and a plot.
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
