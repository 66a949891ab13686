// Paths from outside: only regular files are opened.
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <array>

#include "core/base/error.h"
#include "files/regular_file.h"
#include "support/scratch_folder.h"

namespace tessera {
namespace test_regular_file {

std::string mistake(const std::string& path, std::size_t most_bytes = 100) {
  try {
    read_regular_file(path, most_bytes);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no mistake found";
}

TEST(RegularFile, IsReadAlsoThroughALink) {
  const test::ScratchFolder folder;
  const std::vector<std::uint8_t> abc = {'a', 'b', 'c'};
  EXPECT_EQ(read_regular_file(folder.write("file", "abc"), 3), abc);
  std::filesystem::create_symlink("file", folder.path("link"));
  EXPECT_EQ(read_regular_file(folder.path("link"), 3), abc);
  EXPECT_TRUE(read_regular_file(folder.write("empty", ""), 0).empty());
}

/// Links such as /dev/stdin lead to a file that is already open.
TEST(RegularFile, IsReadThroughALinkOfTheKernel) {
  const test::ScratchFolder folder;
  const FileDescriptor file = open_regular_file(folder.write("file", "abc"));
  EXPECT_EQ(read_regular_file("/proc/self/fd/" + std::to_string(file.number()), 3).size(), 3u);
}

TEST(RegularFile, IsReadFromAPlaceUpToItsEnd) {
  const test::ScratchFolder folder;
  const std::string path = folder.write("file", "abcdef");
  std::array<std::uint8_t, 4> bytes{};
  EXPECT_EQ(read_at(path, open_regular_file(path), 3, bytes), 3u);
  EXPECT_EQ(bytes, (std::array<std::uint8_t, 4>{'d', 'e', 'f', 0}));
  EXPECT_EQ(read_at(path, open_regular_file(path), 9, bytes), 0u);
}

TEST(RegularFile, MayNotBeLargerThanAllowed) {
  const test::ScratchFolder folder;
  const std::string file = folder.write("file", std::string((3u << 20) + 1, 'x'));
  EXPECT_EQ(mistake(file, 2u << 20), file + ": 4 MiB, more than the 2 MiB allowed");
  EXPECT_EQ(mistake(file, 64u << 10), file + ": 3073 KiB, more than the 64 KiB allowed");
  EXPECT_EQ(mistake(file, 100), file + ": 3145729 bytes, more than the 100 bytes allowed");
  EXPECT_EQ(mistake(file, 3u << 20), file + ": 4 MiB, more than the 3 MiB allowed");
}

TEST(RegularFile, OtherThingsAreRefusedAndNamed) {
  const test::ScratchFolder folder;
  const std::string pipe = folder.path("pipe"), link = folder.path("link");
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  std::filesystem::create_symlink("pipe", link);
  const std::string allowed = ", allowed: a regular file";
  EXPECT_EQ(mistake(pipe), pipe + ": not a readable file: found a pipe" + allowed);
  EXPECT_EQ(mistake(link), link + ": not a readable file: found a pipe" + allowed);
  EXPECT_EQ(mistake(folder.path("")), folder.path("") + ": not a readable file: found a folder" + allowed);
  EXPECT_EQ(mistake("/dev/zero"), "/dev/zero: not a readable file: found a device" + allowed);
  EXPECT_EQ(mistake("/proc/kmsg"), "/proc/kmsg: not a readable file: found a file of the kernel (proc)" + allowed);
  EXPECT_EQ(mistake("/proc/self/status"),
            "/proc/self/status: not a readable file: found a file of the kernel (proc)" + allowed);
  EXPECT_EQ(
      mistake("/sys/kernel/mm/transparent_hugepage/enabled").find("/sys/kernel/mm/transparent_hugepage/enabled: "), 0u);
  EXPECT_NE(mistake(folder.path("none")).find("No such file"), std::string::npos);
}

}  // namespace test_regular_file
}  // namespace tessera
