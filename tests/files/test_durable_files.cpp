// The order of writes to the disk. After a power cut every name has a whole file, and everything that the program reported as done is
// there.
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "checkpoint/checkpoint_folder.h"
#include "core/base/error.h"
#include "files/atomic_file.h"
#include "recorded_disk.h"
#include "support/scratch_folder.h"

namespace tessera {
namespace test_durable_files {

using Steps = std::vector<std::string>;
using test::RecordedDisk;

std::string content_of(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

std::vector<std::uint8_t> bytes_of(const std::string& text) { return {text.begin(), text.end()}; }

TEST(DurableFiles, AFileIsFlushedThenRenamedThenItsFolderFlushed) {
  const test::ScratchFolder folder;
  const RecordedDisk disk;
  write_file_atomically(folder.path("card.json"), std::string_view("12345"));
  EXPECT_EQ(disk.steps(), (Steps{"flush card.json.tmp (5 bytes)", "rename card.json.tmp card.json", "flush folder"}));
}

TEST(DurableFiles, WhatAnotherWriterWroteIsFlushedTheSameWay) {
  const test::ScratchFolder folder;
  TemporaryFile file(folder.path("lib.h5"));
  const FileDescriptor other = file.duplicate();
  ASSERT_EQ(::write(other.number(), "1234567", 7), 7);
  const RecordedDisk disk;
  file.commit();
  EXPECT_EQ(disk.steps(), (Steps{"flush lib.h5.tmp (7 bytes)", "rename lib.h5.tmp lib.h5", "flush folder"}));
}

TEST(DurableFiles, ACheckpointIsOnTheDiskBeforeAnyOtherLosesItsName) {
  const test::ScratchFolder scratch;
  const CheckpointFolder folder(scratch.path(""));
  folder.keep(bytes_of("first"));
  const RecordedDisk disk;
  folder.keep(bytes_of("second"));
  ASSERT_GE(disk.steps().size(), 5u);
  EXPECT_EQ(disk.steps().front(), "flush checkpoint.h5.tmp (6 bytes)") << "the previous one is given up before";
  const auto at = [&](const std::string& step) {
    const auto found = std::find(disk.steps().begin(), disk.steps().end(), step);
    EXPECT_NE(found, disk.steps().end()) << step;
    return found;
  };
  EXPECT_LT(at("link checkpoint.h5 checkpoint.previous.h5.tmp"),
            at("rename checkpoint.previous.h5.tmp checkpoint.previous.h5"));
  EXPECT_LT(at("rename checkpoint.previous.h5.tmp checkpoint.previous.h5"),
            at("rename checkpoint.h5.tmp checkpoint.h5"));
  EXPECT_LT(at("rename checkpoint.h5.tmp checkpoint.h5"), at("flush folder"));
  EXPECT_EQ(disk.steps().back(), "flush folder");
}

/// Some disks reserve space late and report a full disk only at the flush.
TEST(DurableFiles, AFlushThatFailsLeavesBothCheckpoints) {
  const test::ScratchFolder scratch;
  const CheckpointFolder folder(scratch.path(""));
  folder.keep(bytes_of("first"));
  folder.keep(bytes_of("second"));
  {
    RecordedDisk full;
    full.fail_flushes();
    EXPECT_THROW(folder.keep(bytes_of("third")), EnvironmentError);
  }
  EXPECT_EQ(content_of(folder.latest()), "second");
  EXPECT_EQ(content_of(folder.previous()), "first");
  EXPECT_FALSE(std::filesystem::exists(temporary_path(folder.latest())));
}

TEST(DurableFiles, AFlushThatFailsLeavesTheFileThatWasThere) {
  const test::ScratchFolder folder;
  const std::string path = folder.write("collage.png", "old");
  {
    RecordedDisk full;
    full.fail_flushes();
    EXPECT_THROW(write_file_atomically(path, std::string_view("new")), EnvironmentError);
  }
  EXPECT_EQ(content_of(path), "old");
  EXPECT_FALSE(std::filesystem::exists(temporary_path(path)));
}

/// The disk is not waited for once per file.
TEST(DurableFiles, OfManyFilesAllAreFlushedTogetherBeforeTheFirstIsRenamed) {
  constexpr std::size_t kFiles = 200;
  const test::ScratchFolder folder;
  std::vector<std::string> names;
  Steps flushes, renames;
  const RecordedDisk disk;
  for (std::size_t i = 0; i < kFiles; ++i) {
    const std::string name = std::to_string(100 + i) + ".svg";
    names.push_back(name);
    TemporaryFile file(folder.path(name));
    file.write(bytes_of("12345"));
    file.leave();
    flushes.push_back("flush " + name + ".tmp (5 bytes)");
    renames.push_back("rename " + name + ".tmp " + name);
  }
  EXPECT_TRUE(disk.steps().empty()) << "a file waited for the disk";
  flush_left_files(folder.path(""), names);
  Steps flushed = disk.steps();
  std::sort(flushed.begin(), flushed.end());
  EXPECT_EQ(flushed, flushes);
  take_left_files(folder.path(""), names);
  renames.push_back("flush folder");
  EXPECT_EQ(Steps(disk.steps().begin() + kFiles, disk.steps().end()), renames);
}

TEST(DurableFiles, OfManyFilesAFlushThatFailsIsTold) {
  const test::ScratchFolder folder;
  const std::vector<std::string> names = {"a.svg"};
  TemporaryFile file(folder.path("a.svg"));
  file.write(bytes_of("12345"));
  file.leave();
  RecordedDisk full;
  full.fail_flushes();
  EXPECT_THROW(flush_left_files(folder.path(""), names), EnvironmentError);
}

}  // namespace test_durable_files
}  // namespace tessera
