// A checkpoint is read back to the bit. Every cut, change or forgery gives one InputError that names it.
#include <gtest/gtest.h>
#include <hdf5.h>
#include <rapidcheck/gtest.h>
#include <sys/stat.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>

#include "checkpoint/checkpoint_file.h"
#include "checkpoint/checkpoint_seal.h"
#include "core/base/error.h"
#include "files/atomic_file.h"
#include "random_state.h"
#include "support/scratch_folder.h"

namespace tessera {
namespace test_checkpoint_file {

namespace fs = std::filesystem;
using test::RandomState;
using test::ScratchFolder;

Checkpoint random_checkpoint(std::uint32_t seed) {
  return {"seed = " + std::to_string(seed) + "\n", seed + 1ull, ~std::uint64_t(seed), seed + 2ull,
          RandomState(seed).make()};
}

bool same(const Candidate& a, const Candidate& b) {
  return a.shape == b.shape && a.source == b.source && a.canvas_from_shape == b.canvas_from_shape &&
         a.terms == b.terms && a.score == b.score && a.exact == b.exact && a.window == b.window &&
         a.perimeter == b.perimeter && a.radius == b.radius;
}

bool same(const PooledSample& a, const PooledSample& b) {
  return a.id == b.id && a.truncated == b.truncated &&
         std::equal(a.candidates.begin(), a.candidates.end(), b.candidates.begin(), b.candidates.end(),
                    [](const Candidate& p, const Candidate& q) { return same(p, q); });
}

bool same(const RunStatistics& a, const RunStatistics& b) {
  return a.shapes == b.shapes && a.pads_per_shape == b.pads_per_shape && a.rounds == b.rounds &&
         a.docking_choices == b.docking_choices && a.dockings_evaluated == b.dockings_evaluated &&
         a.refined == b.refined && a.target_samples == b.target_samples && a.trials == b.trials &&
         a.trials_kept == b.trials_kept && a.prune_s == b.prune_s && a.dock_s == b.dock_s &&
         a.objective_s == b.objective_s && a.merge_s == b.merge_s && a.improve_s == b.improve_s &&
         a.total_s == b.total_s;
}

bool same(const CheckpointState& a, const CheckpointState& b) {
  return a.loop == b.loop && a.given == b.given && a.sizes == b.sizes && a.best == b.best && a.search == b.search &&
         a.searched == b.searched && a.batch_pieces == b.batch_pieces && a.batch_worth == b.batch_worth &&
         a.batch_taken == b.batch_taken && a.placements == b.placements && a.stale == b.stale &&
         a.matches == b.matches && a.matched == b.matched && a.rebuilt_digest == b.rebuilt_digest &&
         same(a.statistics, b.statistics) &&
         std::equal(a.pool.begin(), a.pool.end(), b.pool.begin(), b.pool.end(),
                    [](const PooledSample& p, const PooledSample& q) { return same(p, q); });
}

RC_GTEST_PROP(CheckpointFile, comes_back_to_the_bit, (std::uint32_t seed)) {
  const ScratchFolder folder;
  const Checkpoint written = random_checkpoint(seed);
  const std::vector<std::uint8_t> bytes = checkpoint_bytes(written);
  RC_ASSERT(checkpoint_bytes(written) == bytes);
  write_file_atomically(folder.path("c.h5"), bytes);
  const Checkpoint read = read_checkpoint(folder.path("c.h5"));
  RC_ASSERT(read.state.name == folder.path("c.h5"));
  RC_ASSERT(read.job == written.job);
  RC_ASSERT(read.library_digest == written.library_digest);
  RC_ASSERT(read.canvas_digest == written.canvas_digest);
  RC_ASSERT(same(read.state, written.state));
}

TEST(CheckpointFile, OfAnEmptyStateComesBack) {
  const ScratchFolder folder;
  write_file_atomically(folder.path("c.h5"), checkpoint_bytes({}));
  EXPECT_TRUE(same(read_checkpoint(folder.path("c.h5")).state, CheckpointState{}));
}

class DamagedCheckpoint : public testing::Test {
 protected:
  void SetUp() override { write(checkpoint_bytes(random_checkpoint(3))); }

  void write(const std::vector<std::uint8_t>& bytes) {
    bytes_ = bytes;
    write_file_atomically(path_, bytes_);
  }

  std::string complaint() const {
    try {
      read_checkpoint(path_);
      return {};
    } catch (const InputError& error) {
      return error.what();
    }
  }

  void expect_complaint(const std::string& part) const {
    const std::string message = complaint();
    EXPECT_EQ(message.substr(0, path_.size()), path_) << message;
    EXPECT_NE(message.find(part), std::string::npos) << message;
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
  }

  /// Changes the file with the HDF5 API and seals it again, as an attacker would.
  template <class Change>
  void forge(Change change) {
    const hid_t access = H5Pcreate(H5P_FILE_ACCESS);
    H5Pset_libver_bounds(access, H5F_LIBVER_V18, H5F_LIBVER_V18);
    const hid_t file = H5Fopen(path_.c_str(), H5F_ACC_RDWR, access);
    ASSERT_GE(file, 0);
    change(file);
    H5Fclose(file);
    H5Pclose(access);
    seal_again();
  }

  void seal_again() {
    std::ifstream file(path_, std::ios::binary);
    std::vector<std::uint8_t> bytes(std::istreambuf_iterator<char>(file), {});
    seal_checkpoint(bytes);
    write(bytes);
  }

  template <class Number>
  void put(const char* data_set, hid_t type, std::vector<Number> numbers) {
    forge([&](hid_t file) {
      const hid_t set = H5Dopen2(file, data_set, H5P_DEFAULT);
      const hid_t all = H5Dget_space(set);
      numbers.resize(std::size_t(H5Sget_simple_extent_npoints(all)), numbers.back());
      ASSERT_GE(H5Dwrite(set, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, numbers.data()), 0);
      H5Sclose(all);
      H5Dclose(set);
    });
  }

  /// Replaces the data set by another one.
  void replace(const char* data_set, hid_t type, std::vector<hsize_t> dims, hid_t properties = H5P_DEFAULT) {
    forge([&](hid_t file) {
      H5Ldelete(file, data_set, H5P_DEFAULT);
      const hid_t space = H5Screate_simple(int(dims.size()), dims.data(), nullptr);
      const hid_t set = H5Dcreate2(file, data_set, type, space, H5P_DEFAULT, properties, H5P_DEFAULT);
      ASSERT_GE(set, 0);
      H5Dclose(set);
      H5Sclose(space);
    });
  }

  ScratchFolder folder_;
  std::string path_ = folder_.path("checkpoint.h5");
  std::vector<std::uint8_t> bytes_;
};

TEST_F(DamagedCheckpoint, IsFineBeforeTheDamage) {
  EXPECT_EQ(complaint(), "");
  forge([](hid_t) {});
  EXPECT_EQ(complaint(), "");
}

TEST_F(DamagedCheckpoint, CutOffAnywhere) {
  for (std::size_t size = bytes_.size(); size-- > 0;) {
    fs::resize_file(path_, size);
    const std::string message = complaint();
    ASSERT_NE(message.find(size > 0 ? "cut off" : ""), std::string::npos) << size << ": " << message;
    ASSERT_NE(message, "") << size;
  }
}

TEST_F(DamagedCheckpoint, AnyChangedByteIsNoticed) {
  std::fstream file(path_, std::ios::binary | std::ios::in | std::ios::out);
  for (std::size_t at = 0; at < bytes_.size(); ++at) {
    const char right = char(bytes_[at]);
    file.seekp(std::streamoff(at)).put(char(right ^ char(1 << at % 8))).flush();
    ASSERT_NE(complaint(), "") << at;
    file.seekp(std::streamoff(at)).put(right).flush();
  }
  EXPECT_EQ(complaint(), "");
}

// The seal does not protect from forgery. A change under a valid seal gives an error or another checkpoint, never a crash.
TEST_F(DamagedCheckpoint, AnyChangeUnderOurSealIsSurvived) {
  const std::vector<std::uint8_t> right = bytes_;
  std::mt19937 random(9);
  int refused = 0;
  for (int i = 0; i < 400; ++i) {
    std::vector<std::uint8_t> bytes = right;
    for (std::uint32_t changes = 1 + random() % 4; changes > 0; --changes) {
      bytes[kSealBytes + random() % (bytes.size() - kSealBytes)] = std::uint8_t(random());
    }
    seal_checkpoint(bytes);
    std::ofstream(path_, std::ios::binary)
        .write(reinterpret_cast<const char*>(bytes.data()), std::streamsize(bytes.size()));
    refused += !complaint().empty();
  }
  EXPECT_GT(refused, 80);
}

TEST_F(DamagedCheckpoint, BytesBehindTheEnd) {
  std::ofstream(path_, std::ios::app) << "x";
  expect_complaint("damaged");
}

TEST_F(DamagedCheckpoint, OtherFiles) {
  fs::remove(path_);
  expect_complaint("no such file");
  fs::create_directory(path_);
  expect_complaint("found a folder, allowed: a regular file");
  fs::remove(path_);
  ASSERT_EQ(::mkfifo(path_.c_str(), 0600), 0);
  expect_complaint("found a pipe, allowed: a regular file");
  fs::remove(path_);
  fs::create_symlink("/dev/zero", path_);
  expect_complaint("found a device, allowed: a regular file");
  fs::remove(path_);
  folder_.write("checkpoint.h5", "");
  expect_complaint("cut off after 0 bytes");
  folder_.write("checkpoint.h5", "seed = 7\n");
  expect_complaint("not a checkpoint");
  H5Fclose(H5Fcreate(path_.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT));
  expect_complaint("not a checkpoint");
}

TEST_F(DamagedCheckpoint, AnotherVersionNamesBothAndTheCure) {
  std::fstream(path_, std::ios::binary | std::ios::in | std::ios::out).seekp(27).put('2');
  expect_complaint("format version 29, this program reads version 19; continue with the program that wrote it");
}

TEST_F(DamagedCheckpoint, AHugeHoleIsNotRead) {
  fs::resize_file(path_, std::uintmax_t(1) << 40);
  expect_complaint("damaged");
}

TEST_F(DamagedCheckpoint, SealedButNoHdf5) {
  std::vector<std::uint8_t> bytes(5000, 0x55);
  seal_checkpoint(bytes);
  write(bytes);
  expect_complaint("no HDF5 of our format in it");
  bytes.resize(kSealBytes);
  seal_checkpoint(bytes);
  write(bytes);
  expect_complaint("no HDF5 of our format in it");
}

TEST_F(DamagedCheckpoint, AForeignHdf5FileUnderOurSeal) {
  const hid_t access = H5Pcreate(H5P_FILE_ACCESS);
  const hid_t creation = H5Pcreate(H5P_FILE_CREATE);
  H5Pset_userblock(creation, kSealBytes);
  H5Fclose(H5Fcreate(path_.c_str(), H5F_ACC_TRUNC, creation, access));
  seal_again();
  expect_complaint("no HDF5 of our format in it");
  H5Pset_libver_bounds(access, H5F_LIBVER_V18, H5F_LIBVER_V18);
  H5Fclose(H5Fcreate(path_.c_str(), H5F_ACC_TRUNC, creation, access));
  H5Pclose(creation);
  H5Pclose(access);
  seal_again();
  expect_complaint("data set /job is missing");
}

TEST_F(DamagedCheckpoint, MissingDataSet) {
  forge([](hid_t file) { H5Ldelete(file, "/candidates/window", H5P_DEFAULT); });
  expect_complaint("data set /candidates/window is missing");
}

TEST_F(DamagedCheckpoint, LinksToElsewhere) {
  forge([](hid_t file) {
    H5Ldelete(file, "/job", H5P_DEFAULT);
    H5Lcreate_external("other.h5", "/job", file, "/job", H5P_DEFAULT, H5P_DEFAULT);
  });
  expect_complaint("data set /job is only a link");
}

TEST_F(DamagedCheckpoint, DataOutsideTheFile) {
  const std::string secret = folder_.write("secret", std::string(100, 'x'));
  const hid_t properties = H5Pcreate(H5P_DATASET_CREATE);
  H5Pset_external(properties, secret.c_str(), 0, 100);
  replace("/job", H5T_STD_U8LE, {100}, properties);
  H5Pclose(properties);
  expect_complaint("data set /job is not stored as plain bytes");
}

TEST_F(DamagedCheckpoint, CompressedData) {
  const hid_t properties = H5Pcreate(H5P_DATASET_CREATE);
  const hsize_t chunk = 1 << 20;
  H5Pset_chunk(properties, 1, &chunk);
  H5Pset_deflate(properties, 9);
  replace("/job", H5T_STD_U8LE, {hsize_t(1) << 30}, properties);
  H5Pclose(properties);
  expect_complaint("data set /job is not stored as plain bytes");
}

TEST_F(DamagedCheckpoint, WrongTypesAndDimensions) {
  replace("/samples/stale", H5T_IEEE_F64LE, {3});
  expect_complaint("data set /samples/stale is of a wrong type");
  replace("/samples/stale", H5T_STD_U32LE, {3, 2});
  expect_complaint("data set /samples/stale has wrong dimensions");
}

TEST_F(DamagedCheckpoint, RowsWithoutBytesBehindThem) {
  for (const hsize_t rows : {hsize_t(1) << 20, hsize_t(1) << 39, hsize_t(1) << 59}) {
    replace("/samples/stale", H5T_STD_U32LE, {rows});
    EXPECT_NE(complaint().find("data set /samples/stale "), std::string::npos) << complaint();
  }
}

TEST_F(DamagedCheckpoint, TablesThatContradictThemselves) {
  replace("/placements/score", H5T_IEEE_F32LE, {0});
  expect_complaint("damaged: /placements: columns of different length");
}

TEST_F(DamagedCheckpoint, ListsOfFixedLength) {
  replace("/statistics/counts", H5T_STD_U64LE, {0});
  expect_complaint("damaged: a list of fixed length has another one");
}

TEST_F(DamagedCheckpoint, CountsThatLeadAstray) {
  put<std::uint32_t>("/pool/candidates", H5T_NATIVE_UINT32, {4'000'000'000u});
  expect_complaint("damaged: /pool/candidates: a value is out of range");
  put<std::uint32_t>("/pool/candidates", H5T_NATIVE_UINT32, {0});
  expect_complaint("damaged: /pool/candidates does not count /candidates");
}

TEST_F(DamagedCheckpoint, NotANumber) {
  put<float>("/candidates/score", H5T_NATIVE_FLOAT, {NAN});
  expect_complaint("damaged: /candidates: a value is no number");
}

TEST_F(DamagedCheckpoint, TimesBelowZero) {
  put<double>("/statistics/measures", H5T_NATIVE_DOUBLE, {0, -1e-9});
  expect_complaint("/statistics/measures: a value is below 0");
}

TEST_F(DamagedCheckpoint, WorthOfABatch) {
  put<float>("/batch/worth", H5T_NATIVE_FLOAT, {-1e-9f});
  expect_complaint("/batch/worth: a value is out of range");
  put<float>("/batch/worth", H5T_NATIVE_FLOAT, {-INFINITY});
  expect_complaint("damaged: /batch: a value is no number");
}

TEST_F(DamagedCheckpoint, FlagsAndOrder) {
  put<std::uint8_t>("/improving", H5T_NATIVE_UINT8, {2});
  expect_complaint("damaged: /improving: a value is out of range");
  put<std::uint8_t>("/improving", H5T_NATIVE_UINT8, {1});
  put<std::uint32_t>("/samples/stale", H5T_NATIVE_UINT32, {7});
  expect_complaint("damaged: /samples/stale does not ascend");
}

}  // namespace test_checkpoint_file
}  // namespace tessera
