// Drawing processes when threads are scarce, and when all of them are suspended for a while.
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <future>
#include <thread>

#include "drawer_samples.h"
#include "support/room_for_stacks.h"

namespace tessera {
namespace test_drawer_resources {

using namespace std::chrono_literals;
using test::kDisc;
using test::kTwo;
using test::mistake;
using test::RoomForStacks;
using test::svg;

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
  const std::size_t before = threads_of_this_process();  // OpenCV may have some
  const auto drawers = [&] {
    const RoomForStacks few(3);
    return std::make_unique<Drawers>(many);
  }();
  EXPECT_LE(threads_of_this_process(), before + 3);
  EXPECT_GT(threads_of_this_process(), before);
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

/// A batch system suspends a job like this: the process and its drawer stop for longer than a drawing may take.
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
  std::this_thread::sleep_for(300ms);  // the drawing was requested but cannot arrive
  ::kill(job, SIGSTOP);
  std::this_thread::sleep_for(4s);
  for (const pid_t process : {drawer[0], job}) ::kill(process, SIGCONT);
  int status = 0;
  ::waitpid(job, &status, 0);
  EXPECT_EQ(status, 0);
  for (const int end : {go[0], go[1], ready[0], ready[1]}) ::close(end);
}

}  // namespace test_drawer_resources
}  // namespace tessera
