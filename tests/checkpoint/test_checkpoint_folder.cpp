// The folder's latest checkpoint, the one before it, and the job that a checkpoint belongs to.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>

#include "checkpoint/checkpoint_folder.h"
#include "checkpoint/checkpoint_origin.h"
#include "core/base/error.h"
#include "files/atomic_file.h"
#include "library/storage/library_file.h"
#include "support/file_size_limit.h"
#include "support/planted_files.h"
#include "support/random_shape.h"
#include "support/scratch_folder.h"

namespace tessera {
namespace test_checkpoint_folder {

namespace fs = std::filesystem;
using test::ScratchFolder;

class Checkpoints : public testing::Test {
 protected:
  static std::string content_of(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
  }

  void keep(const std::string& text) const { folder_.keep(std::vector<std::uint8_t>(text.begin(), text.end())); }

  std::string failure_of(const std::string& text) const {
    try {
      keep(text);
    } catch (const EnvironmentError& error) {
      return error.what();
    }
    return "none";
  }

  void expect_files(const std::vector<std::string>& names) const {
    std::set<std::string> found;
    for (const auto& entry : fs::directory_iterator(scratch_.path(""))) found.insert(entry.path().filename());
    EXPECT_EQ(found, std::set<std::string>(names.begin(), names.end()));
  }

  ScratchFolder scratch_;
  CheckpointFolder folder_{scratch_.path("")};
};

TEST_F(Checkpoints, TheLatestAndTheOneBefore) {
  EXPECT_FALSE(folder_.has_latest());
  keep("one");
  EXPECT_EQ(content_of(folder_.latest()), "one");
  EXPECT_FALSE(folder_.has_previous());
  keep("two");
  keep("three");
  EXPECT_EQ(content_of(folder_.latest()), "three");
  EXPECT_EQ(content_of(folder_.previous()), "two");
  expect_files({"checkpoint.h5", "checkpoint.previous.h5"});
}

TEST_F(Checkpoints, LeftoversOfAKilledRunDoNotMatter) {
  keep("one");
  scratch_.write("checkpoint.h5.tmp", "half");
  scratch_.write("checkpoint.previous.h5.tmp", "half");
  keep("two");
  EXPECT_EQ(content_of(folder_.previous()), "one");
  expect_files({"checkpoint.h5", "checkpoint.previous.h5"});
}

/// A run killed between the two renames leaves both names on one file.
TEST_F(Checkpoints, OneFileUnderBothNamesLeavesNothingBehind) {
  keep("one");
  fs::create_hard_link(folder_.latest(), folder_.previous());
  keep("two");
  EXPECT_EQ(content_of(folder_.latest()), "two");
  EXPECT_EQ(content_of(folder_.previous()), "one");
  expect_files({"checkpoint.h5", "checkpoint.previous.h5"});
}

TEST_F(Checkpoints, FollowNothingThatOthersPutThere) {
  for (const test::Plant plant : test::kPlants) {
    const test::PlantedFiles planted;
    folder_.remove();
    keep("one");
    for (const std::string& path : {temporary_path(folder_.latest()), temporary_path(folder_.previous())})
      planted.put(plant, path);
    planted.put(plant, folder_.previous());
    keep("two");
    EXPECT_EQ(content_of(folder_.latest()), "two");
    EXPECT_EQ(content_of(folder_.previous()), "one");
    expect_files({"checkpoint.h5", "checkpoint.previous.h5"});
    planted.expect_untouched();
  }
}

TEST_F(Checkpoints, AreRemovedWithTheirLeftovers) {
  keep("one");
  keep("two");
  scratch_.write("checkpoint.h5.tmp", "half");
  scratch_.write("collage.png", "picture");
  folder_.remove();
  folder_.remove();
  expect_files({"collage.png"});
}

/// A run that is interrupted while it deletes the checkpoints still finds the latest one.
TEST_F(Checkpoints, TheLatestGoesLast) {
  keep("one");
  fs::create_directories(folder_.previous() + "/in the way");
  EXPECT_THROW(folder_.remove(), EnvironmentError);
  EXPECT_TRUE(folder_.has_latest());
}

TEST_F(Checkpoints, AFullDiskKeepsBoth) {
  keep("one");
  keep("two");
  {
    const test::FileSizeLimit full(1000);
    EXPECT_EQ(failure_of(std::string(5000, 'x')), "cannot write " + folder_.latest() + ": File too large");
  }
  EXPECT_EQ(content_of(folder_.latest()), "two");
  EXPECT_EQ(content_of(folder_.previous()), "one");
  expect_files({"checkpoint.h5", "checkpoint.previous.h5"});
}

TEST_F(Checkpoints, WhatCannotBeWrittenKeepsTheLatest) {
  keep("one");
  fs::create_directories(folder_.previous() + "/in the way");
  EXPECT_EQ(failure_of("two").substr(0, 13), "cannot write ");
  EXPECT_EQ(content_of(folder_.latest()), "one");
  EXPECT_FALSE(fs::exists(temporary_path(folder_.latest())));
  fs::remove_all(folder_.previous());
  fs::create_directories(temporary_path(folder_.latest()));
  EXPECT_EQ(failure_of("two"), "cannot write " + folder_.latest() +
                                   ": checkpoint.h5.tmp is in the way and cannot be removed: Is a directory");
  EXPECT_EQ(content_of(folder_.latest()), "one");
}

class Origin : public testing::Test {
 protected:
  void SetUp() override {
    job_.library = scratch_.path("library.h5");
    job_.quality = QualityWord::none;  // an effective job has the number instead
    write_library(job_.library, 11);
  }

  static void write_library(const std::string& path, std::uint32_t seed, bool with_original = false) {
    test::RandomShape random(seed, 5);
    LibraryWriter writer(path, {});
    for (int i = 0; i < 3; ++i) {
      Shape shape = random.make();
      shape.artwork.original.assign(with_original ? 100 : 0, 7);
      shape.artwork.path = path;
      writer.append(shape);
    }
    writer.finish();
  }

  CheckpointOrigin origin(const Job& job, const Canvas& canvas = make_rectangle_canvas(100, 80)) const {
    return make_origin(job, LibraryFile(job.library), canvas_digest(canvas));
  }

  Checkpoint checkpoint() const {
    Checkpoint made = make_checkpoint(origin(job_), {});
    made.state.name = "out/checkpoint.h5";
    return made;
  }

  std::string complaint(const CheckpointOrigin& now) const {
    try {
      check_origin(checkpoint(), now);
    } catch (const InputError& error) {
      return error.what();
    }
    return "none";
  }

  static std::string other_job(const std::string& differences) {
    return "out/checkpoint.h5: unfinished work of another job; " + differences +
           "; give what it was then, or another --out";
  }

  ScratchFolder scratch_;
  Job job_;
};

TEST_F(Origin, IsTheSameForTheSame) { EXPECT_EQ(complaint(origin(job_)), "none"); }

TEST_F(Origin, NamesEveryKeyThatDecides) {
  Job now = job_;
  now.settings.seed = 2;
  now.settings.pieces.max_scale_px = 90.5f;
  EXPECT_EQ(complaint(origin(now)), other_job("seed: then 1, now 2; pieces.scale_px: then [20, 160], now [20, 90.5]"));
}

TEST_F(Origin, DevicesOutputTimeAndCheckpointsMayDiffer) {
  Job now = job_;
  now.devices = "cpu";
  now.output.width_px = 100;
  now.output.background = "#000000";
  now.settings.stop.seconds = 9;
  now.checkpoint.every_s = 1;
  EXPECT_EQ(complaint(origin(now)), "none");
}

TEST_F(Origin, AnotherZone) {
  Job now = job_;
  now.canvas.keep_out = "/masks/zoo.svg";
  EXPECT_EQ(complaint(origin(now, make_rectangle_canvas(100, 81))),
            other_job("canvas.keep_out: another content: then \"\", now \"/masks/zoo.svg\""));
}

TEST_F(Origin, AnotherCanvas) {
  Job now = job_;
  now.canvas.file = "/masks/heart.svg";
  EXPECT_EQ(complaint(origin(now, make_rectangle_canvas(100, 81))),
            other_job("canvas.file: another content: then \"\", now \"/masks/heart.svg\""));
  now.canvas.height_px = 900;
  EXPECT_EQ(complaint(origin(now, make_rectangle_canvas(100, 81))),
            other_job("canvas.size_px: then [1000, 1000], now [1000, 900]"));
}

TEST_F(Origin, ACanvasOfAnotherSizeIsAnotherWhateverItsDistances) {
  const Canvas canvas = make_rectangle_canvas(100, 80);
  for (int Canvas::*side : {&Canvas::width_px, &Canvas::height_px}) {
    Canvas other = canvas;
    ++(other.*side);
    EXPECT_NE(canvas_digest(other), canvas_digest(canvas));
  }
}

TEST_F(Origin, ALibraryThatMovedIsTheSame) {
  Job now = job_;
  now.library = scratch_.path("moved.h5");
  fs::copy(job_.library, now.library);
  EXPECT_EQ(complaint(origin(now)), "none");
  write_library(now.library, 11, true);
  EXPECT_EQ(complaint(origin(now)), "none") << "artwork does not decide";
}

TEST_F(Origin, ALibraryThatChanged) {
  const CheckpointOrigin before = origin(job_);
  const std::string path = job_.library;
  write_library(path, 12);
  const CheckpointOrigin after = origin(job_);
  EXPECT_NE(after.library_digest, before.library_digest);
  Checkpoint then = make_checkpoint(before, {});
  then.state.name = "out/checkpoint.h5";
  try {
    check_origin(then, after);
    ADD_FAILURE();
  } catch (const InputError& error) {
    EXPECT_EQ(error.what(), other_job("library.file: another content: \"" + path + "\" has changed since"));
  }
}

}  // namespace test_checkpoint_folder
}  // namespace tessera
