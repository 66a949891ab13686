// tessera-bench, started by `tessera bench`: parses the command line and runs the benchmark.
#include <CLI/CLI.hpp>

#include <array>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>

#include "bench/benchmarks.h"
#include "core/base/error.h"
#include "files/atomic_file.h"
#include "files/own_program.h"
#include "files/regular_file.h"
#include "program/command.h"
#include "program/list_option.h"
#include "program/parsed_command.h"
#include "program/run_main.h"
#include "result/collage_files.h"
#include "terminal/terminal.h"
#include "text/number_text.h"
#include "worker/devices/opencl_devices.h"

namespace tessera::bench {
namespace {

constexpr const char* kBenchExamples =
    "Examples:\n"
    "  tessera bench pairs\n"
    "  tessera bench pairs --library out/animals.h5 --shapes 10000\n"
    "  tessera bench headline --out headline.json\n"
    "  tessera bench table2 --library out/animals.h5 --rows 13a,13b,13c\n"
    "  tessera bench alternatives --library out/animals.h5 --scale-px 20,160 --size 1000 --seed 7\n"
    "  tessera bench quality --library out/animals.h5 --scale-px 60,120 --seconds 32\n"
    "  tessera bench replacing --library out/animals.h5 --scale-px 60,120 --size 10000\n"
    "  tessera bench library --library out/animals.h5 --sizes 100,1000,10000\n"
    "  tessera bench variety --library out/animals.h5 --sizes 100,1000 --pairs 0,100\n"
    "  tessera bench mosaic --library out/openclipart.h5 --image cup.jpg --image rocket.jpg --pieces 2000\n"
    "  tessera bench blocking --shapes silhouettes --twins bench/mpeg7_twins.txt --library-mirrors\n"
    "  tessera bench blocking --shapes silhouettes --descriptors pad,shape-context --queries 100\n"
    "  tessera bench descriptors --shapes silhouettes --minutes 5\n"
    "  tessera bench scenes --shapes silhouettes --twins bench/mpeg7_twins.txt --queries 100\n"
    "  tessera bench scaling --library out/animals.h5 --shapes 10000 --ranks 2,3\n"
    "Each prints a table and writes the same figures as JSON, by default to out/bench_NAME.json.";

using Benchmark = std::function<Report(const Setting&)>;

/// A report replaces only another report: throws InputError where the file exists and is no JSON, such as a library or
/// a picture.
void check_is_report(const std::string& path) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error)) return;
  std::array<std::uint8_t, 1> first{};
  if (read_at(path, open_regular_file(path), 0, first) == 1 && first[0] != '{')
    throw InputError("--out: found " + path + ", which exists and is no JSON file; give another name");
}

int run(const Setting& setting, const Benchmark& benchmark) {
  worker::chosen_devices(setting.devices, {}, "--devices");  // reports mistakes in --devices at once
  const std::filesystem::path folder = std::filesystem::path(setting.out).parent_path();
  prepare_output_directory(folder.empty() ? "." : folder.string());
  check_is_report(setting.out);
  check_can_be_written(setting.out);
  Setting told = setting;
  told.progress = print_message;
  const Report report = benchmark(told);
  write_report(report, setting.out);
  print_lines(report.text + "\n");
  print_line("written to %s", setting.out.c_str());
  return 0;
}

CLI::App* add_benchmark(CLI::App& bench, Command& selected, const std::string& name, const std::string& meaning,
                        Benchmark benchmark) {
  CLI::App* sub = bench.add_subcommand(name, meaning);
  const auto setting = std::make_shared<Setting>();
  setting->out = "out/bench_" + name + ".json";
  sub->add_option("--out", setting->out, "The JSON file")->type_name("FILE.json")->capture_default_str();
  sub->add_flag("--quick", setting->quick,
                "A small version, which only shows that it runs: a small canvas, and few cases unless they are given");
  sub->add_option("--devices", setting->devices, "OpenCL devices, as the job key devices.use")
      ->type_name("USE")
      ->capture_default_str();
  sub->callback([setting, benchmark = std::move(benchmark), &selected] {
    selected.run = [setting, benchmark] { return run(*setting, benchmark); };
  });
  return sub;
}

void add_library_option(CLI::App& sub, std::string& library) {
  sub.add_option("--library", library, "The library file")->required()->type_name("LIB.h5");
}

void add_pairs(CLI::App& bench, Command& selected) {
  const auto options = std::make_shared<PairsOptions>();
  CLI::App* sub =
      add_benchmark(bench, selected, "pairs",
                    "Find pairs by the index and by a scan; pair tests a second, and the most that the machine can do",
                    [options](const Setting& s) { return bench_pairs(s, *options); });
  sub->add_option("--library", options->library, "The library file; default: blobs made from formulas")
      ->type_name("LIB.h5");
  sub->add_option("--shapes", options->shapes,
                  "Number of shapes; default: the library's, or 1,000 blobs. Shapes beyond the library's are "
                  "mirrored and stretched ones")
      ->type_name("N");
}

void add_table2(CLI::App& bench, Command& selected) {
  const auto options = std::make_shared<Table2Options>();
  CLI::App* sub = add_benchmark(bench, selected, "table2", "Jobs of the sizes of the paper's Table 2",
                                [options](const Setting& s) { return bench_table2(s, *options); });
  add_library_option(*sub, options->library);
  add_list_option(*sub, "--rows", options->rows, "Figures of the paper: 1,13a,13b,13c,16,17,18,19,21,22; default: all",
                  {.type_name = "ROW,.."});
}

/// The canvas is a square of at most as many px as a job's.
void add_size_option(CLI::App& sub, int& size_px) {
  sub.add_option("--size", size_px, "Sides of the canvas, px")
      ->check(CLI::Range(16, 10'000))
      ->type_name("PX")
      ->capture_default_str();
}

void add_square_job_options(CLI::App& sub, SquareJob& job) {
  add_library_option(sub, job.library);
  const auto take_sizes = [&job](const std::vector<float>& given) { job.scale_px = {given[0], given[1]}; };
  add_list_option<float>(sub, "--scale-px", take_sizes, "Sizes of the smallest and the largest piece, px",
                         {.type_name = "MIN,MAX", .count = 2})
      ->default_str(significant(double(job.scale_px[0]), 6) + "," + significant(double(job.scale_px[1]), 6));
  add_size_option(sub, job.size_px);
  sub.add_option("--seed", job.seed, "Start of the random numbers")->type_name("N")->capture_default_str();
}

void add_alternatives(CLI::App& bench, Command& selected) {
  const auto job = std::make_shared<SquareJob>();
  CLI::App* sub = add_benchmark(bench, selected, "alternatives", "Compare this engine with other methods on one job",
                                [job](const Setting& s) { return bench_alternatives(s, *job); });
  add_square_job_options(*sub, *job);
}

void add_quality(CLI::App& bench, Command& selected) {
  const auto job = std::make_shared<SquareJob>();
  const auto seconds = std::make_shared<int>(32);
  CLI::App* sub = add_benchmark(bench, selected, "quality", "Gain from longer improving on one job",
                                [=](const Setting& s) { return bench_quality(s, *job, *seconds); });
  add_square_job_options(*sub, *job);
  sub->add_option("--seconds", *seconds, "Time for each of two runs; measured after 1, 2, 4 s and so on")
      ->type_name("S")
      ->capture_default_str();
}

void add_replacing(CLI::App& bench, Command& selected) {
  const auto job = std::make_shared<SquareJob>();
  job->scale_px = {60, 120};
  job->size_px = 10000;
  CLI::App* sub = add_benchmark(bench, selected, "replacing",
                                "A batch of replacement trials on a large canvas: the master's part, and the workers'",
                                [job](const Setting& s) { return bench_replacing(s, *job); });
  add_square_job_options(*sub, *job);
}

void add_models_option(CLI::App& sub, std::string& folder) {
  sub.add_option("--models", folder,
                 "Folder for files of the shapes' models, 27 KB a shape, which are read as a large library's; default: "
                 "models are made each time, and held in memory")
      ->type_name("FOLDER")
      ->check(CLI::ExistingDirectory);
}

void add_sizes_option(CLI::App& sub, std::vector<std::uint32_t>& sizes, const std::string& otherwise) {
  add_list_option(sub, "--sizes", sizes, "Numbers of shapes; beyond the library's, mirrored and stretched ones",
                  {.type_name = "N,.."})
      ->default_str(otherwise);
}

void add_filling_options(CLI::App& sub, int& pieces, int& size_px) {
  sub.add_option("--pieces", pieces, "Pieces to place, at most")
      ->check(CLI::Range(1, 1'000'000))
      ->type_name("N")
      ->capture_default_str();
  add_size_option(sub, size_px);
}

void add_library(CLI::App& bench, Command& selected) {
  const auto options = std::make_shared<LibraryOptions>();
  CLI::App* sub = add_benchmark(bench, selected, "library", "Time and memory as the library grows",
                                [options](const Setting& s) { return bench_library(s, *options); });
  add_library_option(*sub, options->library);
  add_sizes_option(*sub, options->sizes, "100,1000,10000,100000");
  add_filling_options(*sub, options->pieces, options->size_px);
  add_models_option(*sub, options->models);
}

void add_variety(CLI::App& bench, Command& selected) {
  const auto job = std::make_shared<SquareJob>();
  job->size_px = 600;
  const auto options = std::make_shared<VarietyOptions>();
  CLI::App* sub =
      add_benchmark(bench, selected, "variety", "Gain of a collage from more shapes and from more docked pairs",
                    [=](const Setting& s) { return bench_variety(s, *job, *options); });
  add_square_job_options(*sub, *job);
  add_sizes_option(*sub, options->sizes, "100,1000,10000");
  add_list_option(*sub, "--pairs", options->pairs,
                  "Pairs docked for a target sample; 0: none, as the job key match.top_percent = 0",
                  {.type_name = "N,.."})
      ->default_str("0,25,50,100,200,400");
  sub->add_option("--seeds", options->seeds, "Number of collages of each kind; their means are reported")
      ->type_name("N")
      ->default_str("4");
  add_models_option(*sub, options->models);
}

void add_mosaic(CLI::App& bench, Command& selected) {
  const auto options = std::make_shared<MosaicOptions>();
  CLI::App* sub = add_benchmark(bench, selected, "mosaic",
                                "Compare tessera mosaic with metapixel on the same drawings, as seen from afar",
                                [options](const Setting& s) {
                                  options->program = program_beside_own("tessera");
                                  return bench_mosaic(s, *options);
                                });
  add_library_option(*sub, options->library);
  sub->add_option("--image", options->images,
                  "Image that the mosaics show: JPEG, PNG, TIFF, WebP or BMP; may be "
                  "repeated")
      ->required()
      ->type_name("FILE")
      ->allow_extra_args(false)
      ->take_all();
  sub->add_option("--pieces", options->pieces,
                  "Approximate number of pieces; metapixel gets as many tiles as "
                  "tessera lays")
      ->type_name("N")
      ->capture_default_str();
  add_list_option(*sub, "--grounds", options->grounds, "Background colours of metapixel's tiles; one mosaic for each",
                  {.type_name = "#RRGGBB,.."})
      ->default_str("#f3f0ec,#404040");
  sub->add_option("--set", options->settings, "A key of tessera's jobs, as for tessera mosaic; may be repeated")
      ->type_name("KEY=VALUE")
      ->allow_extra_args(false)
      ->take_all();
}

void add_scaling(CLI::App& bench, Command& selected) {
  const auto options = std::make_shared<ScalingOptions>();
  CLI::App* sub = add_benchmark(bench, selected, "scaling", "Speed-up with more workers; starts mpirun itself",
                                [options](const Setting& s) {
                                  options->program = program_beside_own("tessera");
                                  return bench_scaling(s, *options);
                                });
  add_library_option(*sub, options->library);
  sub->add_option("--shapes", options->shapes,
                  "Shapes for the most workers; default: the library's. Shapes beyond these are mirrored and "
                  "stretched ones")
      ->type_name("N");
  add_list_option(*sub, "--ranks", options->ranks, "Numbers of ranks, one of them the master", {.type_name = "N,.."})
      ->default_str("2,3");
  add_filling_options(*sub, options->pieces, options->size_px);
  sub->add_option("--repeats", options->repeats, "Loops of each case; the median counts")
      ->type_name("N")
      ->capture_default_str();
  sub->add_option("--launcher", options->launcher, "Command that starts ranks; -n N PROGRAM is appended")
      ->type_name("COMMAND")
      ->capture_default_str();
}

void add_silhouette_options(CLI::App& sub, SilhouetteOptions& options) {
  sub.add_option("--shapes", options.shapes, "Folder of silhouettes: PNGs, white on black")
      ->required()
      ->type_name("FOLDER");
  sub.add_option("--twins", options.twins, "Pairs of silhouettes that count as one: two names a line")
      ->type_name("FILE");
  sub.add_flag("--library-mirrors", options.mirrors, "Mirror images of all silhouettes are in the library, too");
  const std::map<std::string, bool> edges = {{"removed", true}, {"counted", false}};
  sub.add_option("--edge", options.edge_removed,
                 "Whether the edge of the hider is removed from the boundary, or counts as boundary")
      ->transform(CLI::CheckedTransformer(edges))
      ->type_name("removed|counted")
      ->default_str("removed");
  const std::map<std::string, bool> scales = {{"known", true}, {"unknown", false}};
  sub.add_option("--scale", options.scale_known, "Whether the size of queries is known")
      ->transform(CLI::CheckedTransformer(scales))
      ->type_name("known|unknown")
      ->default_str(options.scale_known ? "known" : "unknown");
  sub.add_option("--noise", options.noise_px, "Noise of the boundary, standard deviation")
      ->type_name("PX")
      ->capture_default_str();
  sub.add_option("--jpeg", options.jpeg_quality, "Queries are drawn as JPEGs of this quality, 1 to 100, and traced")
      ->type_name("QUALITY");
  sub.add_option("--size", options.size, "Size of queries; default: 1, or 0.7 to 1.4 where the scale is unknown")
      ->type_name("FACTOR");
  sub.add_option("--queries", options.queries, "Number of queries at each percentage; default: one of each silhouette")
      ->type_name("N");
  sub.add_option("--seed", options.seed, "Start of the random numbers")->type_name("N")->capture_default_str();
}

void add_blocking(CLI::App& bench, Command& selected) {
  const auto options = std::make_shared<BlockingOptions>();
  CLI::App* sub = add_benchmark(bench, selected, "blocking",
                                "Recognise silhouettes while more and more of their boundary is hidden",
                                [options](const Setting& s) { return bench_blocking(s, *options); });
  add_silhouette_options(*sub, *options);
  add_list_option(*sub, "--blocks", options->blocks, "Percent of the width that is hidden, from the left",
                  {.type_name = "PERCENT,.."})
      ->default_str("0,10,20,30,40,50,60,70,80,90");
  add_list_option(*sub, "--descriptors", options->descriptors,
                  "Descriptors to compare on the same queries: pad, shape-context, triangle-areas, "
                  "curvature-scale-space, integral-invariants, hu-moments",
                  {.type_name = "NAME,.."})
      ->default_str("pad");
}

void add_scenes(CLI::App& bench, Command& selected) {
  const auto options = std::make_shared<ScenesOptions>();
  CLI::App* sub = add_benchmark(bench, selected, "scenes",
                                "Silhouettes recognised below others and behind branches, or where a part was changed",
                                [options](const Setting& s) { return bench_scenes(s, *options); });
  add_silhouette_options(*sub, *options);
  add_list_option(*sub, "--kinds", options->kinds, "Kinds of scenes: clipped, covered, bars, branch, union, changed",
                  {.type_name = "KIND,.."})
      ->default_str("all");
  add_list_option(*sub, "--hidden", options->hidden,
                  "Percent of the area that is hidden, or of the outline that is changed", {.type_name = "PERCENT,.."})
      ->default_str("20,30,40,50,60,70");
  sub->add_option("--left-out", options->left_out,
                  "Half of the classes, or of the shapes of each, are not in the library: precision and recall")
      ->type_name("none|classes|shapes")
      ->capture_default_str();
}

void add_descriptors(CLI::App& bench, Command& selected) {
  const auto options = std::make_shared<DescriptorsOptions>();
  CLI::App* sub = add_benchmark(bench, selected, "descriptors",
                                "The same collage with PADs, shape context and Hu moments: pieces placed a minute",
                                [options](const Setting& s) { return bench_descriptors(s, *options); });
  sub->add_option(
         "--shapes", options->shapes,
         "Folder of silhouettes: PNGs, white on black, of each name before the last dash the first; default: blobs "
         "made from formulas")
      ->type_name("FOLDER");
  sub->add_option("--minutes", options->minutes, "Processor time of each method")->type_name("M")->default_str("1");
  sub->add_option("--pieces", options->pieces, "A method ends after this many pieces; default: when all are placed")
      ->type_name("N");
}

/// No benchmark: it writes pictures instead of a report.
void add_concepts(CLI::App& bench, Command& selected) {
  const auto options = std::make_shared<ConceptsOptions>();
  CLI::App* sub = bench.add_subcommand("concepts", "Draw the figures of docs/concepts");
  add_library_option(*sub, options->library);
  sub->add_option("--to", options->folder, "Folder of the figures")->required()->type_name("FOLDER");
  sub->add_option("--shape", options->shape, "The shape whose PAD is shown; default: the first one")->type_name("NAME");
  sub->add_option("--devices", options->devices, "OpenCL devices, as the job key devices.use")
      ->type_name("USE")
      ->capture_default_str();
  sub->callback([options, &selected] {
    selected.run = [options] {
      draw_concepts(*options);
      print_line("written to %s", options->folder.c_str());
      return 0;
    };
  });
}

void add_benchmarks(CLI::App& bench, Command& selected) {
  bench.footer(kBenchExamples);
  bench.require_subcommand(1);
  add_pairs(bench, selected);
  add_benchmark(bench, selected, "headline", "Two shapes with 25,000,000 docking positions", bench_headline);
  add_table2(bench, selected);
  add_alternatives(bench, selected);
  add_quality(bench, selected);
  add_replacing(bench, selected);
  add_library(bench, selected);
  add_variety(bench, selected);
  add_mosaic(bench, selected);
  add_blocking(bench, selected);
  add_descriptors(bench, selected);
  add_scenes(bench, selected);
  add_scaling(bench, selected);
  add_concepts(bench, selected);
}

Command command_of(int argc, char** argv) {
  CLI::App app("Measure this machine against the paper and the alternatives", "tessera bench");
  Command selected;
  add_benchmarks(app, selected);
  return parsed_command(app, selected, argc, argv);
}

}  // namespace
}  // namespace tessera::bench

int main(int argc, char** argv) {
  return tessera::run_main(argc, argv, [&] { return tessera::bench::command_of(argc, argv); });
}
