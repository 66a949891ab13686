// Library files that are cut, changed, forged or of another kind. Each gives one InputError that names the reason, never a crash or wrong
// shapes.
#include <gtest/gtest.h>
#include <hdf5.h>
#include <sys/stat.h>

#include <cmath>
#include <filesystem>
#include <random>

#include "core/base/error.h"
#include "library/storage/library_file.h"
#include "support/random_shape.h"
#include "support/scratch_folder.h"

namespace tessera {
namespace test_damaged_library {

using test::RandomShape;
using test::ScratchFolder;

const LibraryParts kEverything{
    .outline = true, .field = true, .levels = ~0u, .artwork = true, .original = true, .surroundings = true};

class DamagedLibrary : public testing::Test {
 protected:
  void SetUp() override {
    RandomShape random(11, 5);
    LibraryWriter writer(path_, {});
    for (int i = 0; i < 3; ++i) writer.append(random.make());
    writer.finish();
    std::ifstream file(path_, std::ios::binary);
    bytes_.assign(std::istreambuf_iterator<char>(file), {});
  }

  /// The message of the InputError when the file is opened and read completely; empty if there is none.
  std::string complaint() const {
    try {
      const LibraryFile library(path_);
      library.read(0, library.size(), kEverything);
      return {};
    } catch (const InputError& error) {
      return error.what();
    }
  }

  void expect_complaint(const std::string& part) const {
    const std::string message = complaint();
    EXPECT_NE(message.find(path_), std::string::npos) << message;
    EXPECT_NE(message.find(part), std::string::npos) << message;
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
  }

  /// Changes the file with the HDF5 API.
  template <class Change>
  void change(Change change) const {
    const hid_t access = H5Pcreate(H5P_FILE_ACCESS);
    H5Pset_libver_bounds(access, H5F_LIBVER_V110, H5F_LIBVER_V110);
    const hid_t file = H5Fopen(path_.c_str(), H5F_ACC_RDWR, access);
    ASSERT_GE(file, 0);
    change(file);
    H5Fclose(file);
    H5Pclose(access);
  }

  /// Writes one number into element `index` of the data set, which must exist.
  template <class Number>
  void put(const std::string& data_set, std::vector<hsize_t> index, hid_t type, Number number) const {
    change([&](hid_t file) {
      const hid_t set = H5Dopen2(file, data_set.c_str(), H5P_DEFAULT);
      const hid_t space = H5Dget_space(set);
      const hid_t one = H5Screate(H5S_SCALAR);
      H5Sselect_elements(space, H5S_SELECT_SET, 1, index.data());
      ASSERT_GE(H5Dwrite(set, type, one, space, H5P_DEFAULT, &number), 0);
      H5Sclose(one);
      H5Sclose(space);
      H5Dclose(set);
    });
  }

  ScratchFolder folder_;
  std::string path_ = folder_.path("library.h5");
  std::string bytes_;
};

TEST_F(DamagedLibrary, IsFineBeforeTheDamage) { EXPECT_EQ(complaint(), ""); }

TEST_F(DamagedLibrary, OtherFiles) {
  std::filesystem::remove(path_);
  expect_complaint("no such file");
  std::filesystem::create_directory(path_);
  expect_complaint("found a folder, allowed: a regular file");
  std::filesystem::remove(path_);
  ASSERT_EQ(::mkfifo(path_.c_str(), 0600), 0);
  expect_complaint("found a pipe, allowed: a regular file");
  std::filesystem::remove(path_);
  std::filesystem::create_symlink("/dev/zero", path_);
  expect_complaint("found a device, allowed: a regular file");
  std::filesystem::remove(path_);
  folder_.write("library.h5", "");
  expect_complaint("not an HDF5 file");
  folder_.write("library.h5", "<svg xmlns='http://www.w3.org/2000/svg'/>");
  expect_complaint("not an HDF5 file");
}

TEST_F(DamagedLibrary, OtherHdf5Files) {
  H5Fclose(H5Fcreate(path_.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT));
  expect_complaint("an HDF5 file of an older format");
  const hid_t access = H5Pcreate(H5P_FILE_ACCESS);
  H5Pset_libver_bounds(access, H5F_LIBVER_V110, H5F_LIBVER_V110);
  H5Fclose(H5Fcreate(path_.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, access));
  H5Pclose(access);
  expect_complaint("an HDF5 file of another kind");
}

TEST_F(DamagedLibrary, AnotherVersionNamesBothAndTheCure) {
  change([](hid_t file) {
    const int version = 2;
    const hid_t attribute = H5Aopen(file, "version", H5P_DEFAULT);
    H5Awrite(attribute, H5T_NATIVE_INT, &version);
    H5Aclose(attribute);
  });
  expect_complaint("version 2, this program reads version 1; build it again");
}

TEST_F(DamagedLibrary, EmptyLibrary) {
  { LibraryWriter(path_, {}).finish(); }
  expect_complaint("the library is empty");
}

TEST_F(DamagedLibrary, CutOffAnywhere) {
  const auto expect_cut_off = [&](std::size_t bytes, std::size_t of) {
    std::filesystem::resize_file(path_, bytes);
    EXPECT_EQ(complaint(), path_ + ": cut off: " + std::to_string(bytes) + " of " + std::to_string(of) +
                               " bytes are there; copy it again, or build it again with tessera library build");
    folder_.write("library.h5", bytes_);
  };
  constexpr std::size_t kHeadBytes = 48;
  for (std::size_t part = 1; part < 40; ++part) expect_cut_off(bytes_.size() * part / 40, bytes_.size());
  expect_cut_off(bytes_.size() - 1, bytes_.size());
  for (const std::size_t bytes : {8, 9, 47}) expect_cut_off(bytes, kHeadBytes);
  expect_cut_off(kHeadBytes, bytes_.size());
  std::filesystem::resize_file(path_, 7);
  expect_complaint("not an HDF5 file");
}

// Checksums cover every byte of data and metadata: a change is found, or it hit an unused byte.
TEST_F(DamagedLibrary, ChangedBytesAreFoundOrMeanNothing) {
  const Shape first = LibraryFile(path_).read(0, 1, kEverything).at(0);
  std::mt19937 random(7);
  int found = 0;
  constexpr int kTries = 300;
  for (int i = 0; i < kTries; ++i) {
    std::string damaged = bytes_;
    // Half of the changes hit the first part of the file, where most of the metadata lies.
    const std::size_t at = random() % (i % 2 ? damaged.size() : 8192);
    damaged[at] = char(damaged[at] ^ char(1u << random() % 8));
    folder_.write("library.h5", damaged);
    if (!complaint().empty()) {
      ++found;
    } else {
      const Shape again = LibraryFile(path_).read(0, 1, kEverything).at(0);
      ASSERT_EQ(again.outline, first.outline) << at;
      ASSERT_EQ(again.field.distance.data(), first.field.distance.data()) << at;
      ASSERT_EQ(again.levels[4].samples, first.levels[4].samples) << at;
    }
  }
  EXPECT_GT(found, kTries / 2);
}

TEST_F(DamagedLibrary, NamesTheDataSetOfADamagedChunk) {
  haddr_t address = 0;
  change([&](hid_t file) {
    const hid_t set = H5Dopen2(file, "/field/distance", H5P_DEFAULT);
    const hid_t space = H5Dget_space(set);
    hsize_t corner[3], size = 0;
    unsigned mask = 0;
    ASSERT_GE(H5Dget_chunk_info(set, space, 0, corner, &mask, &address, &size), 0);
    H5Sclose(space);
    H5Dclose(set);
  });
  std::fstream file(path_, std::ios::binary | std::ios::in | std::ios::out);
  file.seekp(std::streamoff(address) + 100);
  file.put('\x55').put('\xaa').put('\x55');
  file.close();
  expect_complaint("data set /field/distance is damaged");
}

TEST_F(DamagedLibrary, MissingDataSet) {
  change([](hid_t file) { H5Ldelete(file, "/levels/2/keypoints", H5P_DEFAULT); });
  expect_complaint("data set /levels/2/keypoints is missing");
}

TEST_F(DamagedLibrary, LinksToElsewhere) {
  change([](hid_t file) {
    H5Ldelete(file, "/field/scale", H5P_DEFAULT);
    H5Lcreate_external("other.h5", "/field/scale", file, "/field/scale", H5P_DEFAULT, H5P_DEFAULT);
  });
  expect_complaint("data set /field/scale");
}

TEST_F(DamagedLibrary, DataOutsideTheFile) {
  const std::string secret = folder_.write("secret", std::string(100, 'x'));
  change([&](hid_t file) {
    H5Ldelete(file, "/field/scale", H5P_DEFAULT);
    const hsize_t rows = 3;
    const hid_t space = H5Screate_simple(1, &rows, nullptr);
    const hid_t properties = H5Pcreate(H5P_DATASET_CREATE);
    H5Pset_external(properties, secret.c_str(), 0, 12);
    H5Dclose(H5Dcreate2(file, "/field/scale", H5T_IEEE_F32LE, space, H5P_DEFAULT, properties, H5P_DEFAULT));
    H5Pclose(properties);
    H5Sclose(space);
  });
  expect_complaint("data set /field/scale is not chunked");
}

TEST_F(DamagedLibrary, WrongType) {
  change([](hid_t file) {
    H5Ldelete(file, "/shapes/radius", H5P_DEFAULT);
    const hsize_t rows = 3;
    const hid_t space = H5Screate_simple(1, &rows, nullptr);
    const hid_t properties = H5Pcreate(H5P_DATASET_CREATE);
    H5Pset_chunk(properties, 1, &rows);
    H5Dclose(H5Dcreate2(file, "/shapes/radius", H5T_IEEE_F64LE, space, H5P_DEFAULT, properties, H5P_DEFAULT));
    H5Pclose(properties);
    H5Sclose(space);
  });
  expect_complaint("data set /shapes/radius is of a wrong type");
}

TEST_F(DamagedLibrary, RowsWithoutBytesBehindThem) {
  change([](hid_t file) {
    const hid_t set = H5Dopen2(file, "/artwork/original", H5P_DEFAULT);
    const hsize_t rows = hsize_t(1) << 50;
    ASSERT_GE(H5Dset_extent(set, &rows), 0);
    H5Dclose(set);
  });
  expect_complaint("data set /artwork/original has too many rows");
}

TEST_F(DamagedLibrary, RowsThatDoNotAgree) {
  change([](hid_t file) {
    const hid_t set = H5Dopen2(file, "/shapes/radius", H5P_DEFAULT);
    const hsize_t rows = 2;
    ASSERT_GE(H5Dset_extent(set, &rows), 0);
    H5Dclose(set);
  });
  expect_complaint("data set /shapes/radius has a wrong number of rows");
}

TEST_F(DamagedLibrary, OffsetsThatLeadAstray) {
  put("/outline/first_point", {1}, H5T_NATIVE_INT64, std::int64_t(1) << 60);
  expect_complaint("data set /outline/first_point: a value is out of range");
}

TEST_F(DamagedLibrary, OffsetsThatGoBack) {
  put("/artwork/first_thumbnail_byte", {0}, H5T_NATIVE_INT64, std::int64_t(30'000));
  expect_complaint("data set /artwork/first_thumbnail_byte: a value is out of range");
}

TEST_F(DamagedLibrary, NegativeOffsets) {
  put("/outline/first_curve", {0}, H5T_NATIVE_INT64, std::int64_t(-1));
  expect_complaint("data set /outline/first_curve: a value is out of range");
}

TEST_F(DamagedLibrary, NotANumber) {
  put("/levels/3/lengths", {2, 100, 4}, H5T_NATIVE_FLOAT, NAN);
  expect_complaint("data set /levels/3/lengths: a value is out of range");
}

// The checksums are valid; only the stored digest reveals the change.
TEST_F(DamagedLibrary, PartsThatAreNotThoseThatWereWritten) {
  put("/field/distance", {1, 100, 4}, H5T_NATIVE_INT16, std::int16_t(1));
  expect_complaint("damaged: shape 1 is not the one that was written");
}

TEST_F(DamagedLibrary, AbsurdNumbers) {
  put("/artwork/size", {0, 1}, H5T_NATIVE_INT, -5);
  expect_complaint("data set /artwork/size: a value is out of range");
}

}  // namespace test_damaged_library
}  // namespace tessera
