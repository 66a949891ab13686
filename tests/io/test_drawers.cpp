// Drawings made in processes of their own: what comes back, and that a bad one costs only itself.
#include <fcntl.h>
#include <glib.h>
#include <gtest/gtest.h>
#include <linux/landlock.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <future>
#include <thread>

#include "artwork_samples.h"
#include "core/base/error.h"
#include "io/artwork/artwork_render.h"
#include "io/artwork/svg_import.h"
#include "io/drawing/drawer_protocol.h"
#include "io/drawing/drawers.h"
#include "io/drawing/shape_codec.h"
#include "scratch_folder.h"

namespace tessera::io {
namespace {

using namespace std::chrono_literals;
using test::Bytes;
using test::disc_with_alpha;
using test::encoded;
using test::kDisc;
using test::svg;

const DrawerSettings kTwo{.processes = 2, .seconds_per_drawing = 20, .bytes_per_process = std::size_t(256) << 20};

/// Aborts librsvg 2.54.
Bytes panicking_svg() {
  std::string matrix;
  for (int i = 0; i < 100 * 100; ++i) matrix += "1 ";
  return svg("<filter id=\"f\"><feConvolveMatrix order=\"100\" kernelMatrix=\"" + matrix +
             "\"/></filter><circle cx=\"30\" cy=\"25\" r=\"20\" filter=\"url(#f)\"/>");
}

/// Takes librsvg minutes.
Bytes slow_svg() {
  std::string blurs;
  for (int i = 0; i < 20000; ++i) blurs += "<feGaussianBlur stdDeviation=\"50\"/>";
  return svg("<filter id=\"f\">" + blurs + "</filter><circle cx=\"30\" cy=\"25\" r=\"20\" filter=\"url(#f)\"/>");
}

std::string mistake(Drawers& drawers, const Bytes& bytes, int side_px = 300) {
  try {
    drawers.render(bytes, "some/file.svg", side_px);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no mistake found";
}

void expect_no_children() {
  EXPECT_EQ(::waitpid(-1, nullptr, WNOHANG), -1);
  EXPECT_EQ(errno, ECHILD);
}

bool equal(const cv::Mat& a, const cv::Mat& b) {
  return a.size() == b.size() && a.type() == b.type() && cv::norm(a, b, cv::NORM_INF) == 0;
}

TEST(Drawers, DrawWhatIsDrawnInOneProcess) {
  Drawers drawers(kTwo);
  for (const Bytes& bytes : {svg(kDisc), encoded(disc_with_alpha(), ".png"), encoded(disc_with_alpha(), ".webp")}) {
    EXPECT_TRUE(equal(drawers.render(bytes, "a", 301), render_artwork(bytes, "a", 301)));
  }
}

TEST(Drawers, ImportWhatIsImportedInOneProcess) {
  Drawers drawers(kTwo);
  EXPECT_EQ(drawers.natural_size(svg(kDisc), "a"), cv::Size2d(100, 50));
  EXPECT_EQ(drawers.natural_size(encoded(disc_with_alpha(), ".png"), "a"), cv::Size2d(300, 200));
  EXPECT_EQ(drawers.import_svg(svg(kDisc), "a", "s7"), import_svg(svg(kDisc), "a", "s7", {100, 50}));
}

TEST(Drawers, TraceWhatIsTracedInOneProcess) {
  Drawers drawers(kTwo);
  for (const TracingSettings& settings : {TracingSettings{}, {{3, 0.25f}, 0.5f}, {{}, 0.1f}}) {
    const auto traced = drawers.shape(svg(kDisc), "/some/disc.svg", settings);
    const auto expected = shape_from_artwork(svg(kDisc), "/some/disc.svg", settings);
    EXPECT_EQ(encode_shape(std::get<ArtworkShape>(traced).shape), encode_shape(std::get<ArtworkShape>(expected).shape));
  }
  EXPECT_EQ(std::get<SkipReason>(drawers.shape(svg(""), "empty.svg", {})), SkipReason::empty);
}

TEST(Drawers, DecodePngsAsTheyAre) {
  Drawers drawers(kTwo);
  const cv::Mat grey(40, 60, CV_8UC1, cv::Scalar(99));
  const cv::Mat small = drawers.decode_png(encoded(grey, ".png"), "a", 100);
  EXPECT_EQ(small.size(), cv::Size(60, 40));
  EXPECT_EQ(small.at<cv::Vec4b>(20, 30), cv::Vec4b(99, 99, 99, 255));
  EXPECT_EQ(drawers.decode_png(encoded(disc_with_alpha(), ".png"), "a", 150).size(), cv::Size(150, 100));
  EXPECT_TRUE(equal(drawers.decode_png(encoded(disc_with_alpha(), ".png"), "a", 300), disc_with_alpha()));
  EXPECT_THROW(drawers.decode_png(svg(kDisc), "a", 100), InputError);
}

TEST(Drawers, MakePdfsWithoutTimeStamps) {
  Drawers drawers(kTwo);
  const Bytes pdf = drawers.pdf_of_svg(svg(kDisc), 200);
  const std::string text(pdf.begin(), pdf.end());
  EXPECT_TRUE(text.starts_with("%PDF-"));
  EXPECT_NE(text.find("/MediaBox [ 0 0 200 100 ]"), std::string::npos);
  EXPECT_EQ(text.find("CreationDate"), std::string::npos);
  EXPECT_EQ(pdf, drawers.pdf_of_svg(svg(kDisc), 200));
  EXPECT_THROW(drawers.pdf_of_svg(Bytes(10, 'x'), 200), InputError);
}

TEST(Drawers, APdfThatCannotBeMadePieceByPieceIsMadeAsAWhole) {
  Drawers drawers(kTwo);
  const std::string odd = "<g id=\"layer-pieces\"><g id=\"piece-0-a\" transform=\"scale(2)\">" + std::string(kDisc) + "</g></g>";
  const Bytes pdf = drawers.pdf_of_svg(svg(odd), 200);
  EXPECT_TRUE(std::string(pdf.begin(), pdf.end()).starts_with("%PDF-"));
}

TEST(Drawers, NameTheFileAndTheReason) {
  Drawers drawers(kTwo);
  EXPECT_TRUE(mistake(drawers, Bytes(1000, '<')).starts_with("some/file.svg: not a readable SVG file"));
  EXPECT_TRUE(mistake(drawers, {}).starts_with("some/file.svg: neither SVG nor"));
  EXPECT_NE(mistake(drawers, svg(kDisc), 0).find("allowed are 1 to"), std::string::npos);
}

TEST(Drawers, APanicCostsItsOwnDrawing) {
  Drawers drawers(kTwo);
  EXPECT_NO_THROW(drawers.render(svg(kDisc), "a", 100));
  EXPECT_EQ(mistake(drawers, panicking_svg()), std::string("some/file.svg: ") + test::kPanicReason);
  EXPECT_NO_THROW(drawers.render(svg(kDisc), "a", 100));
}

/// An image of 10,000 x 10,000 px in 10 kB. librsvg leaves out what it has no memory for.
TEST(Drawers, WhatNeedsTooMuchMemoryIsTold) {
#ifdef __SANITIZE_ADDRESS__
  GTEST_SKIP() << "the sanitizer has an allocator of its own";
#endif
  const Bytes png = encoded(cv::Mat(10000, 10000, CV_8UC1, cv::Scalar(0)), ".png");
  gchar* base64 = g_base64_encode(png.data(), png.size());
  const Bytes bomb =
      svg(std::string("<image width=\"100\" height=\"50\" xlink:href=\"data:image/png;base64,") + base64 + "\"/>");
  g_free(base64);
  Drawers drawers(kTwo);
  EXPECT_NO_THROW(drawers.render(svg(kDisc), "a", 100));
  EXPECT_EQ(mistake(drawers, bomb), "some/file.svg: needs more than 256 MiB of memory");
  EXPECT_EQ(mistake(drawers, svg(kDisc, R"(width="99" height="99")"), kMaxArtworkSide_px),
            "some/file.svg: needs more than 256 MiB of memory");
  EXPECT_NO_THROW(drawers.render(svg(kDisc), "a", 100));
}

TEST(Drawers, WhatTakesTooLongIsEnded) {
  DrawerSettings settings = kTwo;
  settings.seconds_per_drawing = 0.5;
  Drawers drawers(settings);
  const auto start = std::chrono::steady_clock::now();
  EXPECT_EQ(mistake(drawers, slow_svg()), "some/file.svg: took longer than 0.5 s");
  EXPECT_LT(std::chrono::steady_clock::now() - start, 5s);
  EXPECT_NO_THROW(drawers.render(svg(kDisc), "a", 100));
}

TEST(Drawers, ServeSeveralThreads) {
  Drawers drawers(kTwo);
  std::vector<std::future<cv::Mat>> drawings;
  for (int i = 0; i < 12; ++i) {
    drawings.push_back(std::async(std::launch::async, [&, i] { return drawers.render(svg(kDisc), "a", 100 + i); }));
  }
  for (int i = 0; i < 12; ++i) EXPECT_EQ(drawings[std::size_t(i)].get().cols, 100 + i);
}

TEST(Drawers, StopEndsWhatIsUnderWay) {
  Drawers drawers(kTwo);
  auto drawing = std::async(std::launch::async, [&] { drawers.render(slow_svg(), "a", 300); });
  auto waiting = std::async(std::launch::async, [&] { drawers.render(slow_svg(), "a", 300); });
  std::this_thread::sleep_for(300ms);
  const auto start = std::chrono::steady_clock::now();
  drawers.stop();
  EXPECT_THROW(drawing.get(), DrawingStopped);
  EXPECT_THROW(waiting.get(), DrawingStopped);
  EXPECT_THROW(drawers.render(svg(kDisc), "a", 100), DrawingStopped);
  EXPECT_LT(std::chrono::steady_clock::now() - start, 1s);
}

TEST(Drawers, LeaveNoProcessBehind) {
  { Drawers(kTwo).render(svg(kDisc), "a", 100); }
  expect_no_children();
}

/// While it lives a thread's stack is so large that the address space has room for so many of them; a stack that cannot
/// be mapped is no thread. Stacks of threads that have ended are of another size, so they are not taken again.
class RoomForStacks {
 public:
  explicit RoomForStacks(int count) {
    ::pthread_getattr_default_np(&usual_);
    pthread_attr_t large;
    ::pthread_getattr_default_np(&large);
    ::pthread_attr_setstacksize(&large, kStack_bytes);
    ::pthread_setattr_default_np(&large);
    ::pthread_attr_destroy(&large);
    const std::size_t bytes = std::size_t(count) * kStack_bytes + kStack_bytes / 2;
    std::size_t pages = 0;
    std::ifstream("/proc/self/statm") >> pages;
    ::getrlimit(RLIMIT_AS, &before_);
    const rlimit little{pages * std::size_t(::sysconf(_SC_PAGESIZE)) + bytes, before_.rlim_max};
    ::setrlimit(RLIMIT_AS, &little);
  }
  ~RoomForStacks() {
    ::setrlimit(RLIMIT_AS, &before_);
    ::pthread_setattr_default_np(&usual_);
    ::pthread_attr_destroy(&usual_);
  }

 private:
  static constexpr std::size_t kStack_bytes = std::size_t(512) << 20;

  pthread_attr_t usual_{};
  rlimit before_{};
};

std::size_t threads_of_this_process() {
  const std::filesystem::directory_iterator tasks("/proc/self/task");
  return std::size_t(std::distance(begin(tasks), end(tasks)));
}

TEST(Drawers, FewerThreadsDoTheSameWork) {
#ifdef __SANITIZE_ADDRESS__
  GTEST_SKIP() << "the sanitizer maps a shadow of all addresses";
#endif
  DrawerSettings many = kTwo;
  many.processes = 64;
  const auto drawers = [&] {
    const RoomForStacks few(3);
    return std::make_unique<Drawers>(many);
  }();
  EXPECT_LE(threads_of_this_process(), 1u + 3);
  EXPECT_GT(threads_of_this_process(), 1u);
  std::vector<std::future<cv::Mat>> drawings;
  for (int i = 0; i < 6; ++i) {
    drawings.push_back(std::async(std::launch::async, [&, i] { return drawers->render(svg(kDisc), "a", 100 + i); }));
  }
  for (int i = 0; i < 6; ++i) EXPECT_EQ(drawings[std::size_t(i)].get().cols, 100 + i);
}

TEST(Drawers, WithoutAnyThreadItIsSaid) {
#ifdef __SANITIZE_ADDRESS__
  GTEST_SKIP() << "the sanitizer maps a shadow of all addresses";
#endif
  const RoomForStacks none(0);
  try {
    const Drawers drawers(kTwo);
    ADD_FAILURE() << "a thread without a stack";
  } catch (const EnvironmentError& error) {
    EXPECT_TRUE(std::string(error.what()).starts_with("cannot start a thread: ")) << error.what();
  }
}

std::vector<pid_t> children_of(pid_t process) {
  std::vector<pid_t> children;
  for (const auto& task : std::filesystem::directory_iterator("/proc/" + std::to_string(process) + "/task")) {
    std::ifstream list(task.path() / "children");
    for (pid_t child = 0; list >> child;) children.push_back(child);
  }
  return children;
}

/// As a batch system suspends a job: the process and its drawer, for longer than a drawing may take by the clock.
TEST(Drawers, SuspensionLosesNoDrawing) {
  int go[2], ready[2];
  ASSERT_EQ(::pipe(go) + ::pipe(ready), 0);
  const pid_t job = ::fork();
  if (job == 0) {
    Drawers drawers({.processes = 1, .seconds_per_drawing = 1});
    char byte = 0;
    drawers.render(svg(kDisc), "a", 100);
    if (::write(ready[1], "x", 1) != 1 || ::read(go[0], &byte, 1) != 1) ::_exit(2);
    ::_exit(mistake(drawers, svg(kDisc)) == "no mistake found" ? 0 : 1);
  }
  char byte = 0;
  ASSERT_EQ(::read(ready[0], &byte, 1), 1);
  const std::vector<pid_t> drawer = children_of(job);
  ASSERT_EQ(drawer.size(), 1u);
  ::kill(drawer[0], SIGSTOP);
  ASSERT_EQ(::write(go[1], "x", 1), 1);
  std::this_thread::sleep_for(300ms);  // the drawing is asked for, and does not come
  ::kill(job, SIGSTOP);
  std::this_thread::sleep_for(4s);
  for (const pid_t process : {drawer[0], job}) ::kill(process, SIGCONT);
  int status = 0;
  ::waitpid(job, &status, 0);
  EXPECT_EQ(status, 0);
  for (const int end : {go[0], go[1], ready[0], ready[1]}) ::close(end);
}

/// Another program in place of tessera-drawer while it lives.
class OtherProgram {
 public:
  explicit OtherProgram(const std::string& file) { ::setenv("TESSERA_DRAWER", file.c_str(), 1); }
  ~OtherProgram() { ::setenv("TESSERA_DRAWER", place_.c_str(), 1); }

 private:
  std::string place_ = std::getenv("TESSERA_DRAWER");
};

TEST(Drawers, AMissingProgramIsSaid) {
  for (const char* file : {"/nowhere/tessera-drawer", "/bin/true", "/etc/passwd"}) {
    const OtherProgram program(file);
    EXPECT_THROW(Drawers(kTwo).render(svg(kDisc), "a", 100), EnvironmentError) << file;
  }
}

/// Says so much as its greeting, and waits.
std::string greeting_program(const test::ScratchFolder& folder, const std::string& greeting) {
  const std::string script =
      folder.write("program", "#!/bin/sh\ncat " + folder.write("greeting", greeting) + " >&3\nexec sleep 100\n");
  std::filesystem::permissions(script, std::filesystem::perms::owner_all);
  return script;
}

std::string text_of(const DrawerGreeting& greeting) {
  return std::string(kDrawerMark.begin(), kDrawerMark.end()) +
         std::string(reinterpret_cast<const char*>(&greeting), sizeof greeting);
}

/// What is said of a drawer that greets so.
std::string refusal_of(const std::string& greeting) {
  const test::ScratchFolder folder;
  const OtherProgram program(greeting_program(folder, greeting));
  DrawerSettings settings = kTwo;
  settings.seconds_to_start = 1;
  try {
    Drawers(settings).render(svg(kDisc), "a", 100);
  } catch (const EnvironmentError& error) {
    return error.what();
  }
  return "it was taken";
}

TEST(Drawers, ADrawerOfAnotherBuildIsSaid) {
  DrawerGreeting greeting{this_build(), {}};
  greeting.build.name = {};
  std::ranges::copy(std::string_view("0.0.1, commit abc"), greeting.build.name.begin());
  const std::string message = refusal_of(text_of(greeting));
  EXPECT_NE(message.find("program: it is tessera 0.0.1, commit abc, and this program is tessera "), std::string::npos)
      << message;
  EXPECT_NE(message.find("both must be of one build"), std::string::npos) << message;
}

/// Two builds of one commit, with changes that are not committed.
TEST(Drawers, ADrawerWithOtherHeadersIsSaid) {
  DrawerGreeting greeting{this_build(), {}};
  greeting.build.header_bytes[1] += 8;
  const std::string message = refusal_of(text_of(greeting));
  EXPECT_NE(message.find("program: it was built from other sources"), std::string::npos) << message;
}

/// Older ones said no more than a mark.
TEST(Drawers, ADrawerOfAnOlderVersionIsSaidAtOnce) {
  const std::string message = refusal_of("drawer01");
  EXPECT_NE(message.find("program: it is of another version of tessera"), std::string::npos) << message;
}

TEST(Drawers, ADrawerThatDoesNotAnswerIsSaid) {
  for (const std::string& greeting : {std::string(), std::string(kDrawerMark.begin(), kDrawerMark.end())}) {
    const std::string message = refusal_of(greeting);
    EXPECT_NE(message.find("program: did not answer within 1 s"), std::string::npos) << message;
  }
}

TEST(Drawers, TellWhichLayersHold) {
  const test::ScratchFolder folder;
  Drawers drawers({.processes = 1, .seconds_per_drawing = 0.1});
  for (const LayerState files : {LayerState::missing, LayerState::failed, LayerState::holds}) {
    const OtherProgram program(greeting_program(folder, text_of({this_build(), {files, LayerState::holds}})));
    EXPECT_EQ(mistake(drawers, svg(kDisc)), "some/file.svg: took longer than 0.1 s");
    EXPECT_GE(drawers.layers().files, files);
    EXPECT_EQ(drawers.layers().system_calls, LayerState::holds);
  }
  EXPECT_EQ(drawers.layers().files, LayerState::failed) << "one process is enough";
}

/// A process can be confined 16 times, and passes that on to its children.
TEST(Drawers, ALayerThatFailsIsTold) {
  if (::syscall(SYS_landlock_create_ruleset, nullptr, 0, LANDLOCK_CREATE_RULESET_VERSION) < 1) {
    GTEST_SKIP() << "this kernel has no Landlock";
  }
  const pid_t job = ::fork();
  if (job == 0) {
    landlock_ruleset_attr attributes{};
    attributes.handled_access_fs = LANDLOCK_ACCESS_FS_MAKE_SYM;
    const long rules = ::syscall(SYS_landlock_create_ruleset, &attributes, sizeof attributes.handled_access_fs, 0);
    ::prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0);
    for (int i = 0; i < 16; ++i) ::syscall(SYS_landlock_restrict_self, rules, 0);
    Drawers drawers(kTwo);
    drawers.render(svg(kDisc), "a", 100);
    ::_exit(drawers.layers().files == LayerState::failed ? 0 : 1);
  }
  int status = 0;
  ::waitpid(job, &status, 0);
  EXPECT_EQ(status, 0);
}

TEST(DrawerLayers, AreToldInALine) {
  EXPECT_EQ(layers_note({}), "");
  const DrawerLayers without{LayerState::missing, LayerState::holds};
  EXPECT_FALSE(any_failed(without));
  EXPECT_EQ(layers_note(without),
            "Landlock, which this kernel lacks, does not limit which files foreign drawings can read");
  const DrawerLayers bad{LayerState::failed, LayerState::failed};
  EXPECT_TRUE(any_failed(bad));
  EXPECT_EQ(layers_note(bad),
            "Landlock, which failed here, does not limit which files foreign drawings can read; "
            "seccomp, which failed here, does not limit what foreign drawings can do");
}

/// A font that is read through a link out of the fonts' folder, in place of the drawer's files.
class OwnFonts {
 public:
  explicit OwnFonts(const test::ScratchFolder& folder) : fonts_(folder.path("fonts")) {
    std::filesystem::create_directories(fonts_);
    std::filesystem::create_directories(folder.path("private"));
    std::filesystem::copy(kSans, fonts_);
    std::filesystem::copy(kMono, folder.path("private/mono.ttf"));
    const std::string config = folder.write("fonts.conf", "<fontconfig><dir>" + fonts_ + "</dir></fontconfig>");
    ::setenv("FONTCONFIG_FILE", config.c_str(), 1);
  }
  ~OwnFonts() { ::unsetenv("FONTCONFIG_FILE"); }

  static bool are_there() { return std::filesystem::exists(kSans) && std::filesystem::exists(kMono); }
  std::string mono() const { return fonts_ + "/mono.ttf"; }

 private:
  static constexpr const char* kSans = "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf";
  static constexpr const char* kMono = "/usr/share/fonts/truetype/dejavu/DejaVuSansMono.ttf";

  std::string fonts_;
};

TEST(Drawers, ReadNothingInAPrivateFolder) {
  if (::syscall(SYS_landlock_create_ruleset, nullptr, 0, LANDLOCK_CREATE_RULESET_VERSION) < 1) {
    GTEST_SKIP() << "this kernel has no Landlock";
  }
  if (!OwnFonts::are_there()) GTEST_SKIP() << "DejaVu's fonts are not installed";
  const test::ScratchFolder folder;
  const OwnFonts fonts(folder);
  const Bytes text = svg("<text x=\"5\" y=\"40\" font-size=\"30\" font-family=\"DejaVu Sans Mono\">illi</text>");
  const auto drawn = [&] { return Drawers(kTwo).render(text, "a", 300); };
  const cv::Mat without = drawn();
  std::filesystem::create_symlink(folder.path("private/mono.ttf"), fonts.mono());
  EXPECT_TRUE(equal(drawn(), without));
  std::filesystem::remove(fonts.mono());
  std::filesystem::copy(folder.path("private/mono.ttf"), fonts.mono());
  EXPECT_FALSE(equal(drawn(), without)) << "the font makes no difference";
}

std::string content_of(const std::string& path) {
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), {}};
}

TEST(Drawers, InheritNeitherAnEnvironmentOfRanksNorOpenFiles) {
  const test::ScratchFolder folder;
  const std::string script =
      folder.write("program", "#!/bin/sh\n/usr/bin/env > " + folder.path("environment") + "\n/bin/ls /proc/$$/fd > " +
                                  folder.path("descriptors") + "\n");
  std::filesystem::permissions(script, std::filesystem::perms::owner_all);
  const int inherited = ::fcntl(STDOUT_FILENO, F_DUPFD, 77);  // without O_CLOEXEC
  for (const char* name : {"OMPI_COMM_WORLD_RANK", "PMIX_RANK", "SLURM_PROCID"}) ::setenv(name, "1", 1);
  const OtherProgram program(script);
  EXPECT_THROW(Drawers(kTwo).render(svg(kDisc), "a", 100), EnvironmentError);
  for (const char* name : {"OMPI_COMM_WORLD_RANK", "PMIX_RANK", "SLURM_PROCID"}) ::unsetenv(name);
  ::close(inherited);
  const std::string environment = content_of(folder.path("environment"));
  EXPECT_NE(environment.find("LC_ALL=C.UTF-8"), std::string::npos);
  for (const char* name : {"OMPI_", "PMIX_", "SLURM_"}) EXPECT_EQ(environment.find(name), std::string::npos) << name;
  const std::string descriptors = "\n" + content_of(folder.path("descriptors"));
  EXPECT_NE(descriptors.find("\n3\n"), std::string::npos) << descriptors;
  EXPECT_EQ(descriptors.find("\n" + std::to_string(inherited) + "\n"), std::string::npos) << descriptors;
}

}  // namespace
}  // namespace tessera::io
