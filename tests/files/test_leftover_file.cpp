// The program notes files that a signal would leave behind, and removes them.
#include "files/leftover_file.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <optional>
#include <vector>

#include "core/base/error.h"
#include "files/atomic_file.h"
#include "files/new_folder.h"
#include "files/output_folder.h"
#include "files/output_lock.h"
#include "support/scratch_folder.h"

namespace tessera {
namespace test_leftover_file {

namespace fs = std::filesystem;

class LeftoverFiles : public testing::Test {
 protected:
  bool is_there(const std::string& name) const { return fs::exists(folder_.path(name)); }

  test::ScratchFolder folder_;
};

TEST_F(LeftoverFiles, GoWhileTheyAreNoted) {
  folder_.write("noted", "x");
  folder_.write("finished", "x");
  const LeftoverFile noted(folder_.path("noted"));
  { const LeftoverFile finished(folder_.path("finished")); }
  remove_leftover_files();
  EXPECT_FALSE(is_there("noted"));
  EXPECT_TRUE(is_there("finished"));
}

TEST_F(LeftoverFiles, OfAChildProcessStay) {
  folder_.write("noted", "x");
  const LeftoverFile noted(folder_.path("noted"));
  const pid_t child = fork();
  if (child == 0) {
    remove_leftover_files();
    _exit(0);
  }
  waitpid(child, nullptr, 0);
  EXPECT_TRUE(is_there("noted"));
}

/// Notes more files than there are slots.
TEST_F(LeftoverFiles, MayBeMany) {
  std::vector<std::optional<LeftoverFile>> all(200);
  for (std::size_t i = 0; i < all.size(); ++i) all[i].emplace(folder_.write("file_" + std::to_string(i), "x"));
  remove_leftover_files();
  EXPECT_FALSE(is_there("file_0"));
  all.clear();
  folder_.write("again", "x");
  const LeftoverFile again(folder_.path("again"));
  remove_leftover_files();
  EXPECT_FALSE(is_there("again"));
}

TEST_F(LeftoverFiles, ALockAndTheFoldersThatWereMadeForIt) {
  const OutputFolder folder(folder_.path("a/b"));
  const OutputLock lock(folder_.path("a/b/run.lock"), "b");
  remove_leftover_files();
  EXPECT_FALSE(is_there("a"));
}

TEST_F(LeftoverFiles, AFolderStaysThatIsNotEmptyOrWasThere) {
  fs::create_directory(folder_.path("before"));
  const OutputFolder before(folder_.path("before")), made(folder_.path("made/in"));
  folder_.write("made/kept", "x");
  remove_leftover_files();
  EXPECT_TRUE(is_there("before"));
  EXPECT_TRUE(is_there("made/kept"));
  EXPECT_FALSE(is_there("made/in"));
}

TEST_F(LeftoverFiles, AnOutputFolderGoesWhereNothingCameIntoIt) {
  { const OutputFolder folder(folder_.path("a/b")); }
  EXPECT_FALSE(is_there("a"));
  {
    const OutputFolder folder(folder_.path("a/b"));
    folder_.write("a/b/result", "x");
  }
  EXPECT_TRUE(is_there("a/b/result"));
}

TEST_F(LeftoverFiles, AnOutputFolderThatCannotBeIsTold) {
  folder_.write("file", "x");
  EXPECT_THROW(OutputFolder(folder_.path("file/folder")), InputError);
  EXPECT_THROW(OutputFolder("/proc/tessera"), EnvironmentError);
  EXPECT_THROW(OutputFolder("/proc"), EnvironmentError) << "it is there, but takes no files";
  EXPECT_NO_THROW(OutputFolder(""));
}

// The handler of tessera's own signals before a command has its own (end_at_once_when_signalled).
void remove_and_end(int) {
  remove_leftover_files();
  _exit(0);
}

TEST_F(LeftoverFiles, ProbesOfOutputsLeaveNothingWhicheverMomentEndsThem) {
  for (int k = 0; k < 60; ++k) {
    const pid_t child = fork();
    if (child == 0) {
      std::signal(SIGTERM, remove_and_end);
      for (;;) check_can_be_written(folder_.path("collage.png"));
    }
    usleep(useconds_t(2000 + 37 * k));
    kill(child, SIGTERM);
    ASSERT_EQ(waitpid(child, nullptr, 0), child);
    ASSERT_FALSE(is_there("collage.png.tmp")) << "end " << k;
  }
}

// Slots are reused: the slot of "out" comes once after and once before that of "out/in".
TEST_F(LeftoverFiles, FoldersGoInWhicheverOrderTheyAreNoted) {
  for (const bool outer_first : {true, false}) {
    fs::create_directories(folder_.path("out/in/one"));
    const std::string outer = folder_.path("out"), inner = folder_.path("out/in");
    const LeftoverFile first(outer_first ? outer : inner), second(outer_first ? inner : outer);
    const LeftoverFile innermost(folder_.path("out/in/one"));
    remove_leftover_files();
    EXPECT_FALSE(is_there("out")) << outer_first;
  }
}

using NewFolders = LeftoverFiles;

const std::vector<NewFile> kTwo = {{"pieces/one", {1}}, {"two", {2}}};

TEST_F(NewFolders, HoldWhatIsWritten) {
  NewFolder folder(folder_.path("out/new"));
  folder.write(kTwo, never_stop);
  EXPECT_TRUE(is_there("out/new/pieces/one") && is_there("out/new/two"));
}

TEST_F(NewFolders, HoldNothingWhereWritingStops) {
  {
    NewFolder folder(folder_.path("out/new"));
    const auto stop_at_second = [asked = 0]() mutable {
      if (++asked == 2) throw Interrupted{StopReason::signal};
    };
    EXPECT_THROW(folder.write(kTwo, stop_at_second), Interrupted);
    EXPECT_FALSE(is_there("out/new/pieces"));
  }
  EXPECT_FALSE(is_there("out"));
}

TEST_F(NewFolders, HoldNothingWhereAFileCannotBeWritten) {
  {
    NewFolder folder(folder_.path("new"));
    EXPECT_THROW(folder.write({{"pieces/one", {1}}, {"pieces/one/two", {2}}}, never_stop), EnvironmentError);
  }
  EXPECT_FALSE(is_there("new"));
}

TEST_F(NewFolders, AreEmptyAndForOneRun) {
  folder_.write("file", "x");
  EXPECT_THROW(NewFolder(folder_.path("")), InputError);
  fs::create_directory(folder_.path("empty"));
  const NewFolder empty(folder_.path("empty"));
  const pid_t other = fork();  // a lock belongs to a process
  if (other == 0) {
    try {
      const NewFolder same(folder_.path("empty"));
    } catch (const InputError&) {
      _exit(7);
    }
    _exit(0);
  }
  int status = 0;
  waitpid(other, &status, 0);
  EXPECT_EQ(WEXITSTATUS(status), 7);
}

}  // namespace test_leftover_file
}  // namespace tessera
