// A file appears whole or not at all.
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/sysmacros.h>
#include <unistd.h>

#include <atomic>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <thread>

#include "core/base/error.h"
#include "files/atomic_file.h"
#include "support/file_size_limit.h"
#include "support/planted_files.h"
#include "support/scratch_folder.h"

namespace tessera {
namespace test_atomic_file {

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

TEST(AtomicFile, NothingIsFollowedThatOthersPutUnderTheTemporaryNameOrTheLastOne) {
  for (const test::Plant plant : test::kPlants) {
    const test::ScratchFolder folder;
    const test::PlantedFiles planted;
    const std::string path = folder.path("card.json");
    planted.put(plant, path);
    planted.put(plant, temporary_path(path));
    check_can_be_written(path);
    write_file_atomically(path, std::string_view("ours"));
    EXPECT_EQ(content_of(path), "ours");
    EXPECT_TRUE(fs::is_regular_file(fs::symlink_status(path)));
    EXPECT_FALSE(fs::exists(fs::symlink_status(temporary_path(path))));
    planted.expect_untouched();
  }
}

/// An attacker keeps putting a link back as fast as possible. Each write either gives a file with our bytes or reports its failure.
TEST(AtomicFile, AnAttackerWhoNeverRestsChangesNothing) {
  const test::ScratchFolder folder;
  const test::PlantedFiles planted;
  const std::string path = folder.path("card.json");
  std::atomic<bool> done = false;
  std::thread attacker([&] {
    for (int i = 0; !done; ++i) {
      std::error_code ignored;
      fs::remove(temporary_path(path), ignored);
      fs::create_symlink("/proc/self/mem", temporary_path(path), ignored);
      if (i % 2) continue;
      fs::remove(temporary_path(path), ignored);
      ::mkfifo(temporary_path(path).c_str(), 0600);
    }
  });
  int written = 0;
  for (int i = 0; i < 200; ++i) {
    const std::string failure = failure_of(path, "ours " + std::to_string(i));
    if (failure != "no failure") {
      EXPECT_EQ(failure.find("cannot write " + path), 0u) << failure;
      continue;
    }
    ++written;
    EXPECT_EQ(content_of(path), "ours " + std::to_string(i));
  }
  done = true;
  attacker.join();
  RecordProperty("written", written);
}

TEST(AtomicFile, StaysInItsFolderWhereTheNameLeadsElsewhereBynow) {
  const test::ScratchFolder scratch;
  fs::create_directory(scratch.path("out"));
  fs::create_directory(scratch.path("users"));
  std::ofstream(scratch.path("users/card.json")) << "precious";
  TemporaryFile file(scratch.path("out/card.json"));
  fs::rename(scratch.path("out"), scratch.path("moved"));
  fs::create_symlink("users", scratch.path("out"));
  file.write(std::vector<std::uint8_t>{'a'});
  file.commit();
  EXPECT_EQ(content_of(scratch.path("moved/card.json")), "a");
  EXPECT_EQ(content_of(scratch.path("users/card.json")), "precious");
}

TEST(AtomicFile, AnotherFileUnderTheTemporaryNameIsNotTakenForOurs) {
  const test::ScratchFolder folder;
  const std::string path = folder.write("x.png", "old");
  TemporaryFile file(path);
  file.write(std::vector<std::uint8_t>{'a'});
  fs::remove(temporary_path(path));
  std::ofstream(temporary_path(path)) << "of another run";
  EXPECT_THROW(file.commit(), EnvironmentError);
  EXPECT_EQ(content_of(path), "old");
  EXPECT_EQ(content_of(temporary_path(path)), "of another run");
}

TEST(AtomicFile, ADeviceIsNotReplaced) {
  const test::ScratchFolder folder;
  const std::string path = folder.path("null");
  if (::mknod(path.c_str(), S_IFCHR | 0600, makedev(1, 3)) != 0) GTEST_SKIP() << "may not make a device";
  EXPECT_EQ(failure_of(path, "x"), "cannot write " + path + ": it is a device");
  EXPECT_TRUE(fs::is_character_file(path));
}

TEST(AtomicFile, WhatIsNotCommittedIsRemoved) {
  const test::ScratchFolder folder;
  const std::string path = folder.path("x.png");
  {
    TemporaryFile file(path);
    file.write(std::vector<std::uint8_t>{'a'});
    EXPECT_TRUE(fs::exists(temporary_path(path)));
  }
  EXPECT_TRUE(fs::is_empty(folder.path("")));
}

TEST(AtomicFile, AnUnnamedFileCanBeReadBack) {
  const test::ScratchFolder folder;
  const test::PlantedFiles planted;
  planted.put(test::Plant::link, folder.path("x.tiff.tmp.level"));
  const FileDescriptor file = create_unnamed_file(folder.path("x.tiff"), ".level");
  ASSERT_EQ(::write(file.number(), "abc", 3), 3);
  char bytes[3] = {};
  EXPECT_EQ(::pread(file.number(), bytes, 3, 0), 3);
  EXPECT_EQ(std::string(bytes, 3), "abc");
  EXPECT_TRUE(fs::is_empty(folder.path("")));
  planted.expect_untouched();
}

TEST(AtomicFile, WhatCannotBeWrittenIsFoundBefore) {
  const test::ScratchFolder folder;
  const auto complaint = [](const std::string& path) {
    try {
      check_can_be_written(path);
    } catch (const EnvironmentError& error) {
      return std::string(error.what());
    }
    return std::string("none");
  };
  EXPECT_EQ(complaint(folder.path("card.json")), "none");
  EXPECT_TRUE(fs::is_empty(folder.path("")));
  const std::string long_name = folder.path(std::string(256, 'x'));
  EXPECT_EQ(complaint(long_name), "cannot write " + long_name + ": File name too long");
  EXPECT_EQ(complaint(folder.path("none/x")), "cannot write " + folder.path("none/x") + ": No such file or directory");
  fs::create_directories(folder.path("folder"));
  EXPECT_EQ(complaint(folder.path("folder")), "cannot write " + folder.path("folder") + ": Is a directory");
  fs::create_directories(folder.path("x.tmp/inside"));
  EXPECT_EQ(complaint(folder.path("x")),
            "cannot write " + folder.path("x") + ": x.tmp is in the way and cannot be removed: Is a directory");
  folder.write("busy.tmp", "another run is writing here");
  EXPECT_EQ(complaint(folder.path("busy")), "none");
  EXPECT_EQ(content_of(folder.path("busy.tmp")), "another run is writing here");
}

}  // namespace test_atomic_file
}  // namespace tessera
