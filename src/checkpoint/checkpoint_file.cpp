#include "checkpoint/checkpoint_file.h"

#include <array>
#include <filesystem>

#include "checkpoint/checkpoint_arrays.h"
#include "checkpoint/checkpoint_columns.h"
#include "checkpoint/checkpoint_seal.h"
#include "core/base/error.h"
#include "files/regular_file.h"
#include "library/hdf5/hdf5_trial.h"

namespace tessera {
namespace {

constexpr std::size_t kMemoryStep_bytes = 16384;  // the file is filled up with zeros to a multiple of this

/// An HDF5 file in memory. CheckpointFolder writes its bytes to the disk, where every failure is noticed.
Hdf5Handle create_in_memory() {
  const Hdf5Handle access(H5Pcreate(H5P_FILE_ACCESS), "file");
  // Checksums over all metadata; the next newer format would be marked as still being written.
  hdf5_checked(H5Pset_libver_bounds(access.get(), H5F_LIBVER_V18, H5F_LIBVER_V18), "file");
  hdf5_checked(H5Pset_fapl_core(access.get(), kMemoryStep_bytes, false), "file");
  const Hdf5Handle creation(H5Pcreate(H5P_FILE_CREATE), "file");
  hdf5_checked(H5Pset_userblock(creation.get(), kSealBytes), "file");
  hdf5_checked(H5Pset_obj_track_times(creation.get(), false), "file");
  return {H5Fcreate("checkpoint in memory", H5F_ACC_TRUNC, creation.get(), access.get()), "file"};
}

/// The bytes of a file in memory. H5Fget_file_image is not used: its image has a wrong checksum (HDF5 1.10).
std::vector<std::uint8_t> content_of(hid_t file) {
  hdf5_checked(H5Fflush(file, H5F_SCOPE_GLOBAL), "flush");
  void** memory = nullptr;
  hsize_t size = 0;
  hdf5_checked(H5Fget_vfd_handle(file, H5P_DEFAULT, reinterpret_cast<void**>(&memory)), "memory");
  hdf5_checked(H5Fget_filesize(file, &size), "size");
  const auto* bytes = static_cast<const std::uint8_t*>(*memory);
  return {bytes, bytes + size};
}

void write_columns(hid_t file, const CheckpointColumns& columns) {
  each_column(columns, [&](const char* path, const auto& column, int row, const char* units, const char* description) {
    write_array(file, {path, row, units, description}, column);
  });
}

/// Accepts superblock version 2 only: HDF5 1.10 parses older formats without checksums, and forged ones not safely.
void check_superblock(const std::string& path) {
  constexpr std::uint8_t kVersion = 2;
  std::array<std::uint8_t, 1> found{};
  read_at(path, open_regular_file(path), kSealBytes + 8, found);
  if (found[0] != kVersion) throw Hdf5Error("no HDF5 of our format in it");
}

Hdf5Handle open_for_reading(const std::string& path) {
  check_superblock(path);
  H5PLset_loading_state(0);  // loads no plug-ins
  const Hdf5Handle access(H5Pcreate(H5P_FILE_ACCESS), "file");
  hdf5_checked(H5Pset_file_locking(access.get(), false, true), "file");  // file systems of clusters often lack locks
  return {H5Fopen(path.c_str(), H5F_ACC_RDONLY, access.get()), "no HDF5 of our format in it"};
}

CheckpointColumns read_columns(const std::string& path) {
  const Hdf5Handle file = open_for_reading(path);
  std::uint64_t budget_bytes = std::filesystem::file_size(path);
  CheckpointColumns columns;
  each_column(columns, [&]<class Number>(const char* name, std::vector<Number>& column, int row, const char* units,
                                         const char* description) {
    column = read_array<Number>(file.get(), {name, row, units, description}, budget_bytes);
  });
  return columns;
}

}  // namespace

std::vector<std::uint8_t> checkpoint_bytes(const Checkpoint& checkpoint) {
  const Hdf5Silence silence;
  try {
    const Hdf5Handle file = create_in_memory();
    write_columns(file.get(), to_columns(checkpoint));
    std::vector<std::uint8_t> bytes = content_of(file.get());
    if (bytes.size() > kMaxCheckpointBytes) throw Hdf5Error("larger than the format allows");
    seal_checkpoint(bytes);
    return bytes;
  } catch (const Hdf5Error& error) {
    throw EnvironmentError(std::string("cannot make a checkpoint: ") + error.what());
  }
}

Checkpoint read_checkpoint(const std::string& path) {
  check_seal(path);
  const Hdf5Silence silence;
  try {
    try_in_child([&] { read_columns(path); });
    Checkpoint checkpoint = from_columns(read_columns(path));
    checkpoint.state.name = path;
    return checkpoint;
  } catch (const Hdf5Error& error) {
    throw InputError(path + ": " + error.what());
  }
}

}  // namespace tessera
