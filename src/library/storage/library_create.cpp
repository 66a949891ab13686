#include "library/storage/library_create.h"

#include <filesystem>

#include "core/shape/shape.h"
#include "library/hdf5/hdf5_attributes.h"
#include "library/storage/library_layout.h"

namespace tessera {
namespace {

/// Creates the file. An invalid handle where the name is taken.
Hdf5Handle create_exclusively(const std::string& name, hid_t creation, hid_t access) {
  const hid_t file = H5Fcreate(name.c_str(), H5F_ACC_EXCL, creation, access);
  std::error_code error;
  const bool is_taken = std::filesystem::symlink_status(name, error).type() != std::filesystem::file_type::not_found;
  return file < 0 && is_taken ? Hdf5Handle() : Hdf5Handle(file, "cannot create the file");
}

Hdf5Handle create_group(hid_t file, const std::string& name) {
  const Hdf5Handle properties(H5Pcreate(H5P_GROUP_CREATE), name);
  hdf5_checked(H5Pset_obj_track_times(properties.get(), false), name);
  return {H5Gcreate2(file, name.c_str(), H5P_DEFAULT, properties.get(), H5P_DEFAULT), "group " + name};
}

void create_level_group(hid_t file, std::size_t k) {
  const Hdf5Handle group = create_group(file, layout::level_group(k));
  write_attribute(group.get(), layout::kSigmaAttribute, kSmoothingLevels[k].sigma);
  write_attribute(group.get(), layout::kCurvePointsAttribute, kSmoothingLevels[k].curve_points);
  write_attribute(group.get(), layout::kSamplesAttribute, kSmoothingLevels[k].samples);
}

}  // namespace

NewLibraryFile create_library_file(const std::string& path) {
  check_can_be_written(path);  // finds problems first that HDF5 would report in obscure words
  const Hdf5Handle access(H5Pcreate(H5P_FILE_ACCESS), "file");
  // The newest format has checksums over all of its metadata, on which the reader relies.
  hdf5_checked(H5Pset_libver_bounds(access.get(), H5F_LIBVER_V110, H5F_LIBVER_V110), "file");
  hdf5_checked(H5Pset_file_locking(access.get(), false, true), "file");  // often missing on cluster file systems
  const Hdf5Handle creation(H5Pcreate(H5P_FILE_CREATE), "file");
  hdf5_checked(H5Pset_obj_track_times(creation.get(), false), "file");
  NewLibraryFile created;
  created.disk = std::make_unique<TemporaryFile>(path, [&](const std::string& name) {
    created.hdf5 = create_exclusively(name, creation.get(), access.get());
    return created.hdf5.get() < 0 ? FileDescriptor(-1) : descriptor_of(created.hdf5.get());
  });
  return created;
}

void write_library_header(hid_t file, const PadParameters& pad) {
  write_attribute(file, layout::kFormatAttribute, std::string(layout::kFormat));
  write_attribute(file, layout::kVersionAttribute, layout::kVersion);
  write_attribute(file, layout::kPadLevelsAttribute, pad.levels);
  write_attribute(file, layout::kDeltaTauAttribute, pad.delta_tau);
  for (const char* name : {"/shapes", "/outline", "/field", "/artwork", "/levels"}) create_group(file, name);
  for (std::size_t k = 0; k < kSmoothingLevels.size(); ++k) create_level_group(file, k);
}

}  // namespace tessera
