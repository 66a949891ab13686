// Harmful SVGs as artwork of a library, as canvas and as original of a picture. Each costs only its own drawing, ends in time, and is
// reported with a reason.
// The calling process keeps its memory small. TESSERA_ALL_ODD_SVGS tries all variants.
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <functional>

#include "artwork/artwork_render.h"
#include "artwork/drawers/drawers.h"
#include "core/base/error.h"
#include "files/work_in_order.h"
#include "job/canvas/canvas_file.h"
#include "library/library_builder.h"
#include "library/storage/library_file.h"
#include "odd_svgs.h"
#include "support/scratch_folder.h"

namespace tessera {
namespace test_odd_svgs {

using test::OddSvg;
using test::OddSvgs;

const int variants = std::getenv("TESSERA_ALL_ODD_SVGS") ? 4 : 1;
constexpr int kThreads = 2;

constexpr double kSeconds = 0.5;
constexpr std::size_t kMebibyte = std::size_t(1) << 20;
/// The memory of a process with its libraries and of the test itself, besides the memory allowed for drawing.
constexpr std::size_t kOwnBytes = 300 * kMebibyte;

const DrawerSettings kSettings{
    .processes = kThreads, .seconds_per_drawing = kSeconds, .bytes_per_process = 256 * kMebibyte};

#ifndef __SANITIZE_ADDRESS__
std::size_t peak_bytes(decltype(RUSAGE_SELF) whose) {
  rusage usage{};
  ::getrusage(whose, &usage);
  return std::size_t(usage.ru_maxrss) << 10;
}

#endif

void expect_little_memory() {
#ifndef __SANITIZE_ADDRESS__
  EXPECT_LT(peak_bytes(RUSAGE_SELF), kOwnBytes);
  EXPECT_LT(peak_bytes(RUSAGE_CHILDREN), kOwnBytes + 512 * kMebibyte);
#endif
}

std::span<const std::uint8_t> bytes_of(const std::string& text) {
  return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

/// The result of a drawing, with its name and its time.
struct Outcome {
  std::string text;
  double seconds = 0;
};

template <class Draw>
Outcome outcome_of(const Draw& draw) {
  const auto start = std::chrono::steady_clock::now();
  Outcome outcome{"drawn"};
  try {
    draw();
  } catch (const InputError& error) {
    outcome.text = error.what();
  }
  outcome.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return outcome;
}

void expect_drawn_or_told(const Outcome& outcome, const std::string& path, double most_seconds) {
  EXPECT_LT(outcome.seconds, most_seconds) << path;
  if (outcome.text == "drawn") return;
  EXPECT_NE(outcome.text.find(path + ": "), std::string::npos) << outcome.text;
  EXPECT_GT(outcome.text.size(), path.size() + 5);
  EXPECT_EQ(outcome.text.find('\n'), std::string::npos) << outcome.text;
}

/// The limit includes a new start of the process on a busy machine.
constexpr double kMostSeconds = kSeconds + 10;

/// The outcomes of all drawings. Several threads call `draw`.
std::vector<Outcome> outcomes_of(std::size_t count, const std::function<void(std::size_t)>& draw) {
  std::vector<Outcome> outcomes;
  OrderedWork<Outcome> job;
  job.count = count;
  job.threads = kThreads;
  job.work = [&](std::size_t i) { return outcome_of([&] { draw(i); }); };
  job.consume = [&](std::size_t, Outcome outcome) { outcomes.push_back(std::move(outcome)); };
  work_in_order(job);
  return outcomes;
}

/// Every third SVG, for the quick test.
std::vector<OddSvg> some_of(const std::vector<OddSvg>& all) {
  std::vector<OddSvg> some;
  for (std::size_t i = 0; i < all.size(); i += variants == 1 ? 3 : 1) some.push_back(all[i]);
  return some;
}

TEST(OddSvg, AsOriginal) {
  Drawers drawers(kSettings);
  const std::vector<OddSvg> all = OddSvgs::make(variants);
  const auto outcomes =
      outcomes_of(all.size(), [&](std::size_t i) { drawers.render(bytes_of(all[i].text), all[i].name, 200); });
  std::size_t drawn = 0;
  for (std::size_t i = 0; i < all.size(); ++i) {
    expect_drawn_or_told(outcomes[i], all[i].name, kMostSeconds);
    if (outcomes[i].text == "drawn") ++drawn;
  }
  EXPECT_GT(drawn, all.size() / 5);
  EXPECT_LT(drawn, all.size() - 5);
  const std::string good = OddSvgs::document("<circle cx=\"200\" cy=\"200\" r=\"150\" fill=\"red\"/>");
  const cv::Mat expected = render_artwork(bytes_of(good), "good", 200);
  for (int k = 0; k < 4; ++k) {
    EXPECT_EQ(cv::norm(drawers.render(bytes_of(good), "good", 200), expected, cv::NORM_INF), 0);
  }
  expect_little_memory();
}

TEST(OddSvg, AsWhatIsDeformed) {
  Drawers drawers(kSettings);
  const std::vector<OddSvg> all = OddSvgs::make(variants);
  Warp warp{.origin = {0, 0}, .step = 10, .displacement = {41, 41}, .active = {40, 40, 1}};
  for (int i = 0; i < 41; ++i) warp.displacement(i, 20) = {3, -2};
  const auto outcomes = outcomes_of(
      all.size(), [&](std::size_t i) { drawers.warped_svg(bytes_of(all[i].text), all[i].name, "odd", warp); });
  for (std::size_t i = 0; i < all.size(); ++i) expect_drawn_or_told(outcomes[i], all[i].name, kMostSeconds);
  expect_little_memory();
}

TEST(OddSvg, AsCanvas) {
  const test::ScratchFolder folder;
  std::vector<CanvasSpec> specs;
  for (const OddSvg& odd : some_of(OddSvgs::make(variants))) {
    specs.push_back({.width_px = 100, .height_px = 100, .file = folder.write(odd.name + ".svg", odd.text)});
  }
  const auto outcomes = outcomes_of(specs.size(), [&](std::size_t i) { load_canvas(specs[i], kSeconds); });
  for (std::size_t i = 0; i < specs.size(); ++i) expect_drawn_or_told(outcomes[i], specs[i].file, 2 * kMostSeconds);
  expect_little_memory();
}

TEST(OddSvg, AsArtworkOfALibrary) {
  const test::ScratchFolder folder;
  const std::vector<OddSvg> all = some_of(OddSvgs::make(variants));
  std::filesystem::create_directory(folder.path("in"));
  for (const OddSvg& odd : all) folder.write("in/" + odd.name + ".svg", odd.text);
  folder.write("in/zzz_good.svg", OddSvgs::document("<path d=\"M70 10A42 42 0 1 0 70 90A50 50 0 0 1 70 10Z\"/>"));
  DrawerSettings patient = kSettings;  // tracing takes longer than drawing
  patient.seconds_per_drawing = 2;
  Drawers drawers(patient);
  LibraryBuildSettings settings;
  settings.files_at_a_time = kThreads;
  const BuildProgress silent = [](std::size_t, std::size_t) {};
  const auto report = build_library(find_artwork({folder.path("in")}, ""), folder.path("out.h5"), settings,
                                    artwork_loader(drawers, {}), silent);
  EXPECT_TRUE(report.written);
  EXPECT_EQ(report.files, all.size() + 1);
  EXPECT_EQ(report.shapes + report.merged.size() + report.skipped.size(), all.size() + 1);
  for (const UnusedFile& file : report.skipped) EXPECT_GT(file.reason.size(), 4u) << file.path;
  const LibraryFile library(folder.path("out.h5"));
  EXPECT_EQ(library.read(library.size() - 1, library.size(), {}).front().name, "zzz_good");
  expect_little_memory();
}

}  // namespace test_odd_svgs
}  // namespace tessera
