#include "checkpoint/checkpoint_arrays.h"

#include "library/hdf5/hdf5_attributes.h"

namespace tessera {
namespace {

template <class Number>
struct Types;
template <>
struct Types<std::uint8_t> {
  static hid_t file() { return H5T_STD_U8LE; }
  static hid_t memory() { return H5T_NATIVE_UINT8; }
};
template <>
struct Types<std::int32_t> {
  static hid_t file() { return H5T_STD_I32LE; }
  static hid_t memory() { return H5T_NATIVE_INT32; }
};
template <>
struct Types<std::uint32_t> {
  static hid_t file() { return H5T_STD_U32LE; }
  static hid_t memory() { return H5T_NATIVE_UINT32; }
};
template <>
struct Types<std::uint64_t> {
  static hid_t file() { return H5T_STD_U64LE; }
  static hid_t memory() { return H5T_NATIVE_UINT64; }
};
template <>
struct Types<float> {
  static hid_t file() { return H5T_IEEE_F32LE; }
  static hid_t memory() { return H5T_NATIVE_FLOAT; }
};
template <>
struct Types<double> {
  static hid_t file() { return H5T_IEEE_F64LE; }
  static hid_t memory() { return H5T_NATIVE_DOUBLE; }
};

/// Properties without time stamps, so that the same checkpoint gives the same bytes.
Hdf5Handle timeless(hid_t kind, const std::string& what) {
  Hdf5Handle properties(H5Pcreate(kind), what);
  hdf5_checked(H5Pset_obj_track_times(properties.get(), false), what);
  return properties;
}

void make_groups(hid_t file, const std::string& path) {
  const Hdf5Handle properties = timeless(H5P_GROUP_CREATE, path);
  for (std::size_t slash = path.find('/', 1); slash != std::string::npos; slash = path.find('/', slash + 1)) {
    const std::string group = path.substr(0, slash);
    if (H5Lexists(file, group.c_str(), H5P_DEFAULT) > 0) continue;
    const Hdf5Handle made(H5Gcreate2(file, group.c_str(), H5P_DEFAULT, properties.get(), H5P_DEFAULT), group);
  }
}

/// Checks that every link of the path is a hard link: soft and external links could lead to other files.
void check_links(hid_t file, const std::string& path) {
  for (std::size_t slash = path.find('/', 1);; slash = path.find('/', slash + 1)) {
    const std::string prefix = path.substr(0, slash);
    H5L_info_t info{};
    if (H5Lexists(file, prefix.c_str(), H5P_DEFAULT) <= 0) throw Hdf5Error("data set " + path + " is missing");
    hdf5_checked(H5Lget_info(file, prefix.c_str(), &info, H5P_DEFAULT), path);
    if (info.type != H5L_TYPE_HARD) throw Hdf5Error("data set " + path + " is only a link");
    if (slash == std::string::npos) return;
  }
}

std::vector<hsize_t> dims_of(const ArrayLayout& layout, hsize_t rows) {
  return layout.row == 1 ? std::vector<hsize_t>{rows} : std::vector<hsize_t>{rows, hsize_t(layout.row)};
}

/// Checks that the data set is stored as plain bytes inside the file.
void check_storage(hid_t data_set, const std::string& what) {
  const Hdf5Handle properties(H5Dget_create_plist(data_set), what);
  if (H5Pget_layout(properties.get()) != H5D_CONTIGUOUS || H5Pget_external_count(properties.get()) != 0 ||
      H5Pget_nfilters(properties.get()) != 0) {
    throw Hdf5Error(what + " is not stored as plain bytes");
  }
}

/// Checks the shape of the data set and returns its number of values.
std::size_t check_dims(hid_t data_set, const ArrayLayout& layout, const std::string& what) {
  const Hdf5Handle space(H5Dget_space(data_set), what);
  hsize_t dims[2] = {0, 1};
  if (H5Sget_simple_extent_ndims(space.get()) != (layout.row == 1 ? 1 : 2))
    throw Hdf5Error(what + " has wrong dimensions");
  hdf5_checked(H5Sget_simple_extent_dims(space.get(), dims, nullptr), what);
  if (dims[1] != hsize_t(layout.row)) throw Hdf5Error(what + " has wrong dimensions");
  constexpr hsize_t kMostRows = hsize_t(1) << 40;  // keeps the number of bytes within 64 bits
  if (dims[0] > kMostRows) throw Hdf5Error(what + " has too many rows");
  return std::size_t(dims[0] * dims[1]);
}

}  // namespace

template <class Number>
void write_array(hid_t file, const ArrayLayout& layout, const std::vector<Number>& numbers) {
  const std::string what = "data set " + layout.path;
  make_groups(file, layout.path);
  const std::vector<hsize_t> dims = dims_of(layout, numbers.size() / std::size_t(layout.row));
  const Hdf5Handle space(H5Screate_simple(int(dims.size()), dims.data(), nullptr), what);
  const Hdf5Handle properties = timeless(H5P_DATASET_CREATE, what);
  const Hdf5Handle data_set(H5Dcreate2(file, layout.path.c_str(), Types<Number>::file(), space.get(), H5P_DEFAULT,
                                       properties.get(), H5P_DEFAULT),
                            what);
  if (!numbers.empty()) {
    hdf5_checked(H5Dwrite(data_set.get(), Types<Number>::memory(), H5S_ALL, H5S_ALL, H5P_DEFAULT, numbers.data()),
                 what);
  }
  write_attribute(data_set.get(), "units", layout.units);
  write_attribute(data_set.get(), "description", layout.description);
}

template <class Number>
std::vector<Number> read_array(hid_t file, const ArrayLayout& layout, std::uint64_t& budget_bytes) {
  const std::string what = "data set " + layout.path;
  check_links(file, layout.path);
  const Hdf5Handle data_set(H5Dopen2(file, layout.path.c_str(), H5P_DEFAULT), what);
  const Hdf5Handle type(H5Dget_type(data_set.get()), what);
  if (H5Tequal(type.get(), Types<Number>::file()) <= 0) throw Hdf5Error(what + " is of a wrong type");
  check_storage(data_set.get(), what);
  const std::size_t count = check_dims(data_set.get(), layout, what);
  if (count == 0) return {};
  const std::uint64_t bytes = std::uint64_t(count) * sizeof(Number);
  if (bytes > budget_bytes || H5Dget_storage_size(data_set.get()) != bytes) throw Hdf5Error(what + " lacks bytes");
  budget_bytes -= bytes;
  std::vector<Number> numbers(count);
  hdf5_checked(H5Dread(data_set.get(), Types<Number>::memory(), H5S_ALL, H5S_ALL, H5P_DEFAULT, numbers.data()), what);
  return numbers;
}

#define TESSERA_ARRAY_OF(Number)                                                            \
  template void write_array<Number>(hid_t, const ArrayLayout&, const std::vector<Number>&); \
  template std::vector<Number> read_array<Number>(hid_t, const ArrayLayout&, std::uint64_t&);
TESSERA_ARRAY_OF(std::uint8_t)
TESSERA_ARRAY_OF(std::int32_t)
TESSERA_ARRAY_OF(std::uint32_t)
TESSERA_ARRAY_OF(std::uint64_t)
TESSERA_ARRAY_OF(float)
TESSERA_ARRAY_OF(double)
#undef TESSERA_ARRAY_OF

}  // namespace tessera
