#include "library/storage/segment_columns.h"

#include <algorithm>
#include <cstdio>
#include <numeric>

#include "library/hdf5/hdf5_attributes.h"
#include "library/storage/library_layout.h"
#include "library/storage/segment_bytes.h"

namespace tessera {
namespace {

constexpr char kGroup[] = "/models";
constexpr char kSegmentShapesAttribute[] = "segment_shapes";

std::string segment_name(std::uint32_t segment) {
  char name[32];
  std::snprintf(name, sizeof name, "segment_%05u", segment);
  return name;
}

Hdf5Handle create_group(hid_t file) {
  const Hdf5Handle properties(H5Pcreate(H5P_GROUP_CREATE), kGroup);
  hdf5_checked(H5Pset_obj_track_times(properties.get(), false), kGroup);
  Hdf5Handle group(H5Gcreate2(file, kGroup, H5P_DEFAULT, properties.get(), H5P_DEFAULT), kGroup);
  write_attribute(group.get(), layout::kVersionAttribute, kModelsVersion);
  write_attribute(group.get(), kSegmentShapesAttribute, int(kSegmentShapes));
  write_attribute(group.get(), layout::kUnitsAttribute, std::string("bytes"));
  write_attribute(
      group.get(), layout::kDescriptionAttribute,
      std::string("what matching needs of the shapes, made of the other data sets: docs/library-format.md"));
  return group;
}

/// Writes bytes in one piece, so that any part of them can be read by its place.
void write_in_one_piece(hid_t group, const std::string& name, const std::vector<std::uint8_t>& bytes) {
  const hsize_t size = bytes.size();
  const Hdf5Handle space(H5Screate_simple(1, &size, nullptr), name);
  const Hdf5Handle properties(H5Pcreate(H5P_DATASET_CREATE), name);
  hdf5_checked(H5Pset_obj_track_times(properties.get(), false), name);
  hdf5_checked(H5Pset_layout(properties.get(), H5D_CONTIGUOUS), name);
  const Hdf5Handle data_set(
      H5Dcreate2(group, name.c_str(), H5T_STD_U8LE, space.get(), H5P_DEFAULT, properties.get(), H5P_DEFAULT), name);
  hdf5_checked(H5Dwrite(data_set.get(), H5T_NATIVE_UINT8, H5S_ALL, H5S_ALL, H5P_DEFAULT, bytes.data()), name);
}

/// The place of a segment in the file. It must be stored as write_in_one_piece() does it.
std::uint64_t place_of(hid_t file, const std::string& name, std::size_t bytes) {
  const std::string path = std::string(kGroup) + "/" + name;
  const std::string what = "data set " + path;
  check_hard_links(file, path, what);
  const Hdf5Handle data_set(H5Dopen2(file, path.c_str(), H5P_DEFAULT), what);
  // Checked before anything else: for a virtual data set HDF5 finds the extent by opening other files.
  const Hdf5Handle properties(H5Dget_create_plist(data_set.get()), what);
  if (H5Pget_layout(properties.get()) != H5D_CONTIGUOUS || H5Pget_external_count(properties.get()) != 0) {
    throw Hdf5Error(what + " is not in one piece");
  }
  const Hdf5Handle type(H5Dget_type(data_set.get()), what);
  const Hdf5Handle space(H5Dget_space(data_set.get()), what);
  if (H5Tequal(type.get(), H5T_STD_U8LE) <= 0 || H5Sget_simple_extent_npoints(space.get()) != hssize_t(bytes)) {
    throw Hdf5Error(what + ": not as many bytes as its models have");
  }
  const haddr_t at = H5Dget_offset(data_set.get());
  if (at == HADDR_UNDEF) throw Hdf5Error(what + ": there is nothing in it");
  return at;
}

}  // namespace

SegmentKind library_segments(const PadParameters& pad) {
  SegmentKind kind{pad.levels, std::vector<int>(kSmoothingLevels.size())};
  std::iota(kind.levels.begin(), kind.levels.end(), 0);
  return kind;
}

SegmentWriter::SegmentWriter(hid_t file, const PadParameters& pad)
    : group_(create_group(file)),
      pad_(pad),
      kind_(library_segments(pad)) {}

void SegmentWriter::append(const Shape& shape, const SegmentOwner& owner) {
  models_.push_back(make_shape_model(shape, pad_, pad_, kind_.levels));
  owners_.push_back(owner);
  if (models_.size() == kSegmentShapes) write();
}

void SegmentWriter::finish() {
  if (!models_.empty()) write();
}

void SegmentWriter::write() {
  write_in_one_piece(group_.get(), segment_name(segments_++), segment_bytes(kind_, models_, owners_));
  models_.clear();
  owners_.clear();
}

SegmentPlaces segment_places(hid_t file, const PadParameters& pad, std::uint32_t shapes) {
  SegmentPlaces places;
  if (H5Lexists(file, kGroup, H5P_DEFAULT) <= 0) return places;
  check_hard_links(file, kGroup, std::string("group ") + kGroup);
  const Hdf5Handle group(H5Gopen2(file, kGroup, H5P_DEFAULT), kGroup);
  if (read_int_attribute(group.get(), layout::kVersionAttribute) != kModelsVersion ||
      read_int_attribute(group.get(), kSegmentShapesAttribute) != int(kSegmentShapes)) {
    return places;
  }
  const SegmentKind kind = library_segments(pad);
  for (std::uint32_t first = 0; first < shapes; first += kSegmentShapes) {
    const std::size_t bytes = SegmentLayout(kind, std::min(kSegmentShapes, shapes - first)).bytes;
    places.begins.push_back(place_of(file, segment_name(first / kSegmentShapes), bytes));
    places.bytes += bytes;
  }
  return places;
}

}  // namespace tessera
