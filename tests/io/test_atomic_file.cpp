// Files appear whole or not at all.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>

#include "core/base/error.h"
#include "file_size_limit.h"
#include "io/atomic_file.h"
#include "scratch_folder.h"

namespace tessera::io {
namespace {

namespace fs = std::filesystem;

std::string content_of(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

std::string failure_of(const std::string& path, std::string_view bytes) {
  try {
    write_file_atomically(path, bytes);
  } catch (const EnvironmentError& error) {
    return error.what();
  }
  return "no failure";
}

TEST(AtomicFile, WritesAndReplaces) {
  const test::ScratchFolder folder;
  const std::string path = folder.path("a file.txt");
  write_file_atomically(path, std::string_view("first, and longer"));
  EXPECT_EQ(content_of(path), "first, and longer");
  write_file_atomically(path, std::string_view("second"));
  EXPECT_EQ(content_of(path), "second");
  EXPECT_FALSE(fs::exists(temporary_path(path)));
}

TEST(AtomicFile, EmptyAndBinaryContent) {
  const test::ScratchFolder folder;
  write_file_atomically(folder.path("empty"), std::string_view());
  EXPECT_EQ(fs::file_size(folder.path("empty")), 0u);
  write_file_atomically(folder.path("binary"), std::vector<std::uint8_t>{0, 255, 0, 10});
  EXPECT_EQ(content_of(folder.path("binary")), std::string("\0\xff\0\n", 4));
}

TEST(AtomicFile, AFolderThatIsNotThereIsNamedWithTheReason) {
  const test::ScratchFolder folder;
  const std::string path = folder.path("missing/x.json");
  EXPECT_EQ(failure_of(path, "x"), "cannot write " + path + ": No such file or directory");
}

TEST(AtomicFile, AFolderInTheWayIsKept) {
  const test::ScratchFolder folder;
  const std::string path = folder.path("taken");
  fs::create_directories(path + "/inside");
  EXPECT_NE(failure_of(path, "x"), "no failure");
  EXPECT_TRUE(fs::exists(path + "/inside"));
  EXPECT_FALSE(fs::exists(temporary_path(path)));
}

TEST(AtomicFile, AFullDiskKeepsTheOldFileAndLeavesNoHalfOne) {
  const test::ScratchFolder folder;
  const std::string path = folder.path("x.png");
  write_file_atomically(path, std::string_view("old"));
  std::string failure;
  {
    const test::FileSizeLimit full(1000);
    failure = failure_of(path, std::string(100000, 'x'));
  }
  EXPECT_EQ(failure, "cannot write " + path + ": File too large");
  EXPECT_EQ(content_of(path), "old");
  EXPECT_FALSE(fs::exists(temporary_path(path)));
}

TEST(AtomicFile, CommitsWhatAnotherWriterWrote) {
  const test::ScratchFolder folder;
  const std::string path = folder.path("lib.h5");
  std::ofstream(temporary_path(path)) << "from elsewhere";
  commit_temporary_file(path);
  EXPECT_EQ(content_of(path), "from elsewhere");
  EXPECT_THROW(commit_temporary_file(path), EnvironmentError);
  EXPECT_EQ(content_of(path), "from elsewhere");
}

}  // namespace
}  // namespace tessera::io
