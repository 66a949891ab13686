// The abilities that a process still has after it limited itself. Each attempt runs in a forked child, since limits cannot be removed.
#include <dlfcn.h>
#include <fcntl.h>
#include <fontconfig/fontconfig.h>
#include <gtest/gtest.h>
#include <linux/landlock.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/ptrace.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <functional>
#include <thread>
#include <vector>

#include "artwork/sandbox/drawer_files.h"
#include "artwork/sandbox/drawer_landlock.h"
#include "artwork/sandbox/drawer_sandbox.h"
#include "support/scratch_folder.h"

namespace tessera {
namespace test_drawer_sandbox {

constexpr std::size_t kBytes = std::size_t(128) << 20;

enum class Layer { none, limits, system_calls };

/// Returns the result of `attempt` in a limited child process.
bool succeeds(Layer layer, const std::function<bool()>& attempt) {
  const pid_t child = ::fork();
  if (child == 0) {
    if (layer == Layer::limits) limit_process(kBytes);
    if (layer == Layer::system_calls && forbid_system_calls() != LayerState::holds) ::_exit(2);
    ::_exit(attempt() ? 1 : 0);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  EXPECT_TRUE(WIFEXITED(status)) << "signal " << WTERMSIG(status);
  return WEXITSTATUS(status) != 0;
}

class SystemCalls : public testing::Test {
 protected:
  void SetUp() override {
    const pid_t child = ::fork();
    if (child == 0) ::_exit(forbid_system_calls() == LayerState::holds ? 0 : 1);
    int status = 0;
    ::waitpid(child, &status, 0);
    if (status != 0) GTEST_SKIP() << "this kernel has no seccomp";
  }

  static bool allowed(const std::function<bool()>& attempt) { return succeeds(Layer::system_calls, attempt); }

  test::ScratchFolder folder_;
};

TEST_F(SystemCalls, FilesAreReadOnly) {
  const std::string file = folder_.write("there", "abc");
  const std::string other = folder_.path("new");
  EXPECT_TRUE(allowed([&] { return ::open(file.c_str(), O_RDONLY) >= 0; }));
  EXPECT_FALSE(allowed([&] { return ::open(file.c_str(), O_WRONLY) >= 0; }));
  EXPECT_FALSE(allowed([&] { return ::open(file.c_str(), O_RDWR) >= 0; }));
  EXPECT_FALSE(allowed([&] { return ::open(file.c_str(), O_RDONLY | O_TRUNC) >= 0; }));
  EXPECT_FALSE(allowed([&] { return ::open(other.c_str(), O_RDONLY | O_CREAT, 0600) >= 0; }));
  EXPECT_FALSE(allowed([&] { return ::creat(other.c_str(), 0600) >= 0; }));
  EXPECT_FALSE(allowed([&] { return ::mkdir(other.c_str(), 0700) == 0; }));
  EXPECT_FALSE(allowed([&] { return ::unlink(file.c_str()) == 0; }));
  EXPECT_FALSE(allowed([&] { return ::rename(file.c_str(), other.c_str()) == 0; }));
  EXPECT_FALSE(allowed([&] { return ::link(file.c_str(), other.c_str()) == 0; }));
  EXPECT_FALSE(allowed([&] { return ::symlink(file.c_str(), other.c_str()) == 0; }));
  EXPECT_FALSE(allowed([&] { return ::chmod(file.c_str(), 0777) == 0; }));
  EXPECT_FALSE(allowed([&] { return ::truncate(file.c_str(), 0) == 0; }));
  EXPECT_FALSE(allowed([&] { return ::mkfifo(other.c_str(), 0600) == 0; }));
  EXPECT_EQ(std::filesystem::file_size(file), 3u);
  EXPECT_FALSE(std::filesystem::exists(other));
}

TEST_F(SystemCalls, ThereIsNoNetwork) {
  for (const int family : {AF_INET, AF_INET6, AF_UNIX, AF_NETLINK}) {
    EXPECT_FALSE(allowed([&] { return ::socket(family, SOCK_STREAM, 0) >= 0; })) << family;
    EXPECT_FALSE(allowed([&] { return ::socket(family, SOCK_DGRAM, 0) >= 0; })) << family;
  }
}

TEST_F(SystemCalls, NoOtherProcessIsStartedOrTouched) {
  const pid_t parent = ::getpid();
  EXPECT_FALSE(allowed([] {
    char* const arguments[] = {const_cast<char*>("false"), nullptr};
    ::execv("/bin/false", arguments);  // /bin/false exits with 1
    return false;
  }));
  EXPECT_FALSE(allowed([] {
    const pid_t child = ::fork();
    if (child == 0) ::_exit(0);
    return child > 0;
  }));
  EXPECT_FALSE(allowed([&] { return ::kill(parent, 0) == 0; }));
  EXPECT_FALSE(allowed([&] { return ::ptrace(PTRACE_ATTACH, parent, nullptr, nullptr) == 0; }));
  EXPECT_FALSE(allowed([&] {
    rlimit limit{};
    return ::prlimit(parent, RLIMIT_CPU, nullptr, &limit) == 0;
  }));
  EXPECT_FALSE(allowed([&] {
    const rlimit limit{RLIM_INFINITY, RLIM_INFINITY};
    return ::setrlimit(RLIMIT_CPU, &limit) == 0;
  }));
}

TEST_F(SystemCalls, ThreadsAndMemoryAreThere) {
  EXPECT_TRUE(allowed([] {
    bool ran = false;
    std::thread([&] { ran = true; }).join();
    const std::vector<char> block(std::size_t(50) << 20, 'x');
    return ran && block[block.size() / 2] == 'x';
  }));
}

/// Returns the result of `attempt` in a child that may read only `readable`, as a drawer.
bool confined(const std::vector<std::string>& readable, const std::function<bool()>& attempt) {
  return succeeds(Layer::limits, [&] { return confine_to_files(readable) == LayerState::holds && attempt(); });
}

class Files : public testing::Test {
 protected:
  void SetUp() override {
    if (!confined({}, [] { return true; })) GTEST_SKIP() << "this kernel has no Landlock";
  }

  static bool opens(const std::string& path) { return ::open(path.c_str(), O_RDONLY) >= 0; }

  test::ScratchFolder folder_;
};

TEST_F(Files, OnlyThoseThatDecodersNeedAreRead) {
  const std::string file = folder_.write("private", "abc");
  const std::vector<std::string> readable = files_of_decoders();
  const auto is_read = [&](const std::string& path) { return confined(readable, [&] { return opens(path); }); };
  for (const std::string& path :
       {file, folder_.path(""), std::string("/etc/passwd"), std::string("/"),
        "/proc/" + std::to_string(::getppid()) + "/environ", std::string("/proc/self/environ"),
        std::string("/proc/self/net/tcp"), std::string("/proc/self/mountinfo")}) {
    EXPECT_FALSE(is_read(path)) << path;
  }
  for (const char* path :
       {"/usr/share", "/etc/fonts/fonts.conf", "/etc/ld.so.cache", "/proc/self/statm", "/dev/null"}) {
    EXPECT_TRUE(is_read(path)) << path;
  }
}

/// A user's setting that leads libraries to the home folder.
struct HomeCase {
  const char* name;
  std::function<void(const std::string& home)> prepare;
};

void list_a_loader_in(const std::string& home) {
  std::ofstream(home + "/loaders.cache") << "\"" << home << "/loader.so\"\n\"/* XPM */\" \"\" 100\n";
  ::setenv("GDK_PIXBUF_MODULE_FILE", (home + "/loaders.cache").c_str(), 1);
}

void look_for_fonts_in(const std::string& home) {
  std::ofstream(home + "/fonts.conf") << "<fontconfig><dir>~</dir></fontconfig>";
  ::setenv("FONTCONFIG_FILE", (home + "/fonts.conf").c_str(), 1);
}

/// A copy of a loaded library counts as another library.
void load_a_library_from(const std::string& home) {
  Dl_info library{};
  ::dladdr(reinterpret_cast<void*>(&FcInitLoadConfig), &library);
  std::filesystem::copy_file(library.dli_fname, home + "/library.so",
                             std::filesystem::copy_options::overwrite_existing);
  ::setenv("LD_LIBRARY_PATH", home.c_str(), 1);
  if (!::dlopen((home + "/library.so").c_str(), RTLD_NOW)) ::_exit(0);
}

class HomeFolder : public Files, public testing::WithParamInterface<HomeCase> {};

TEST_P(HomeFolder, StaysShut) {
  const std::string home = folder_.path("users/me");
  std::filesystem::create_directories(home);
  const std::string secret = folder_.write("users/me/secret", "abc");
  const std::string neighbour = folder_.write("users/secret", "abc");
  for (const std::string& path : {secret, neighbour, home, std::string("/etc/passwd")}) {
    EXPECT_TRUE(succeeds(Layer::none, [&] {
      ::setenv("HOME", home.c_str(), 1);
      GetParam().prepare(home);
      limit_process(kBytes);
      return confine_to_files(files_of_decoders()) == LayerState::holds && !opens(path);
    })) << path;
  }
}

INSTANTIATE_TEST_SUITE_P(Ways, HomeFolder,
                         testing::Values(HomeCase{"Loaders", list_a_loader_in}, HomeCase{"Fonts", look_for_fonts_in},
                                         HomeCase{"Libraries", load_a_library_from}),
                         [](const auto& info) { return info.param.name; });

TEST_F(Files, WhatDecodersLoadLaterIsReadable) {
  for (const char* folder : {"libraries", "loaders"}) std::filesystem::create_directories(folder_.path(folder));
  const std::string library = folder_.write("libraries/library.so", "abc");
  const std::string loader = folder_.write("loaders/loader.so", "abc");
  const std::string needed = folder_.write("loaders/needed.so", "abc");
  const std::string list = folder_.write("loaders.cache", "# a list\n\"" + loader + "\"\n\"png\" 5 \"\" \"\"\n");
  const std::string beside = folder_.write("secret", "abc");
  const auto is_read = [&](const std::string& path) {
    return succeeds(Layer::limits, [&] {
      ::setenv("LD_LIBRARY_PATH", ("/nowhere::" + folder_.path("libraries")).c_str(), 1);
      ::setenv("GDK_PIXBUF_MODULE_FILE", list.c_str(), 1);
      return confine_to_files(files_of_decoders()) == LayerState::holds && opens(path);
    });
  };
  for (const std::string& path : {library, loader, needed, list}) EXPECT_TRUE(is_read(path)) << path;
  EXPECT_FALSE(is_read(beside));
}

TEST_F(Files, NothingIsCutShort) {
  if (::syscall(SYS_landlock_create_ruleset, nullptr, 0, LANDLOCK_CREATE_RULESET_VERSION) < 3) {
    GTEST_SKIP() << "this kernel's Landlock does not know it";
  }
  const std::string file = folder_.write("there", "abc");
  EXPECT_FALSE(confined({folder_.path("")}, [&] { return ::truncate(file.c_str(), 0) == 0; }));
  EXPECT_EQ(std::filesystem::file_size(file), 3u);
}

/// Landlock does not accept a pipe as a place.
TEST_F(Files, ARefusedRuleConfinesNothingAndIsSaid) {
  int pipe[2];
  ASSERT_EQ(::pipe(pipe), 0);
  const std::string refused = "/proc/self/fd/" + std::to_string(pipe[0]);
  EXPECT_TRUE(succeeds(Layer::limits, [&] {
    return confine_to_files({refused, "/usr"}) == LayerState::failed && opens("/etc/passwd");
  }));
  for (const int end : pipe) ::close(end);
}

TEST_F(Files, ALinkCountsAsWhatItLeadsTo) {
  std::filesystem::create_directories(folder_.path("public"));
  const std::string hidden = folder_.write("private", "abc");
  const std::string open = folder_.write("public/open", "abc");
  std::filesystem::create_symlink(hidden, folder_.path("public/link"));
  const std::vector<std::string> readable = {folder_.path("public"), "/nowhere"};
  EXPECT_TRUE(confined(readable, [&] { return opens(open); }));
  EXPECT_FALSE(confined(readable, [&] { return opens(folder_.path("public/link")); }));
  EXPECT_FALSE(confined(readable, [&] { return ::open(open.c_str(), O_WRONLY) >= 0; }));
}

TEST(ProcessLimits, BoundTheMemory) {
#ifdef __SANITIZE_ADDRESS__
  GTEST_SKIP() << "the sanitizer's allocator aborts instead of throwing";
#endif
  const auto takes = [](std::size_t bytes) {
    return [bytes] {
      try {
        const std::vector<char> block(bytes, 'x');
        return block[block.size() / 2] == 'x';
      } catch (const std::bad_alloc&) {
        return false;
      }
    };
  };
  EXPECT_TRUE(succeeds(Layer::limits, takes(kBytes / 2)));
  EXPECT_FALSE(succeeds(Layer::limits, takes(2 * kBytes)));
}

TEST(ProcessLimits, NothingIsWrittenToFiles) {
  const test::ScratchFolder folder;
  const std::string file = folder.path("new");
  EXPECT_FALSE(succeeds(Layer::limits, [&] {
    const int number = ::open(file.c_str(), O_WRONLY | O_CREAT, 0600);
    return ::write(number, "x", 1) == 1;
  }));
  EXPECT_FALSE(succeeds(Layer::limits, [] {
    rlimit limit{};
    ::getrlimit(RLIMIT_CORE, &limit);
    return limit.rlim_max > 0;
  }));
}

TEST(ProcessLimits, TheyHoldForItsDescendants) {
  EXPECT_TRUE(succeeds(Layer::limits, [] { return ::prctl(PR_GET_NO_NEW_PRIVS, 0, 0, 0, 0) == 1; }));
}

TEST(ProcessLimits, ItDiesWithItsParent) {
  int pipe[2];
  ASSERT_EQ(::pipe(pipe), 0);
  const pid_t parent = ::fork();
  if (parent == 0) {
    if (::fork() == 0) {
      limit_process(kBytes);
      if (::write(pipe[1], "x", 1) == 1) ::pause();
      ::_exit(1);
    }
    char ready = 0;
    ::_exit(::read(pipe[0], &ready, 1) == 1 ? 0 : 1);
  }
  ::waitpid(parent, nullptr, 0);
  ::close(pipe[1]);
  char none = 0;
  EXPECT_EQ(::read(pipe[0], &none, 1), 0);  // the end of the pipe: no process has it open any more
}

}  // namespace test_drawer_sandbox
}  // namespace tessera
