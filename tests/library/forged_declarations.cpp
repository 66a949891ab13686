#include "forged_declarations.h"

namespace tessera::test {
namespace {

/// Filters as another or a harmful program could declare them.
hid_t filters_of_way(std::size_t way, const std::vector<hsize_t>& chunk) {
  const hid_t properties = H5Pcreate(H5P_DATASET_CREATE);
  H5Pset_chunk(properties, int(chunk.size()), chunk.data());
  if (way == 1) H5Pset_shuffle(properties);
  if (way == 0 || way == 2) H5Pset_deflate(properties, 9);
  if (way == 0) H5Pset_deflate(properties, 9);
  if (way == 3) H5Pset_fletcher32(properties), H5Pset_deflate(properties, 4);
  if (way == 4) H5Pset_nbit(properties);
  if (way != 5 && way != 3) H5Pset_fletcher32(properties);  // 5: no filter at all
  return properties;
}

hid_t type_of_way(std::size_t way, const Column& column) {
  hid_t type = H5Tcopy(way == 0 ? H5T_IEEE_F64LE : way == 1 ? H5T_IEEE_F32BE : H5T_STD_I8LE);
  if (way < 2) return type;
  H5Tclose(type);
  if (way == 2) type = H5Tcopy(H5T_C_S1), H5Tset_size(type, H5T_VARIABLE);
  if (way == 3) type = H5Tvlen_create(H5T_IEEE_F32LE);
  if (way == 4) type = H5Tcreate(H5T_COMPOUND, 4), H5Tinsert(type, "a", 0, H5T_IEEE_F32LE);
  if (way == 5) type = H5Tcreate(H5T_OPAQUE, layout::element_bytes(column));
  if (way == 6) type = H5Tcopy(H5T_STD_REF_OBJ);
  return type;
}

/// Columns that may be missing, as in older libraries.
bool is_new(const Column& column) {
  return column.path == "/shapes/part_digest" || column.path == "/artwork/path_from_library" ||
         column.path == "/artwork/sha256" || column.path == "/artwork/reader" ||
         column.path == "/artwork/surroundings_margin";
}

/// Columns whose rows are found by offsets: extra rows at their ends belong to no shape.
bool led_to_by_offsets(const Column& column) {
  return column.path == "/outline/points" || column.path == "/artwork/thumbnail_png" ||
         column.path == "/artwork/original" || column.path == "/outline/first_point" ||
         column.path == "/artwork/surroundings_png";
}

}  // namespace

Forgery other_filters(const std::string& path, ForgingChance& chance) {
  const Column& column = chance.any_column();
  const std::size_t way = chance.below(6);
  change_library(path, [&](hid_t file) {
    const OpenColumn open = open_column(file, column);
    const hid_t type = H5Dget_type(open.set);
    const hid_t space = H5Dget_space(open.set);
    const hid_t properties = filters_of_way(way, open.chunk);
    std::vector<char> data(std::size_t(H5Dget_storage_size(open.set)) + open.rows() * layout::row_bytes(column));
    H5Dread(open.set, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, data.data());
    H5Dclose(open.set);
    declare_anew(file, column, type, space, properties);
    const hid_t made = H5Dopen2(file, column.path.c_str(), H5P_DEFAULT);
    H5Dwrite(made, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, data.data());
    H5Dclose(made);
    H5Pclose(properties);
    H5Sclose(space);
    H5Tclose(type);
  });
  return {"filters of way " + std::to_string(way) + " on " + column.path};
}

Forgery giant(const std::string& path, ForgingChance& chance) {
  const Column& column = chance.any_column();
  const int bits = 8 + int(chance.below(54));
  change_library(path, [&](hid_t file) {
    OpenColumn open = open_column(file, column);
    open.dims[0] = open.rows() + (hsize_t(1) << bits);
    H5Dset_extent(open.set, open.dims.data());
    H5Dclose(open.set);
    if (chance.below(2) != 0) return;
    for (const Column& other : chance.columns()) {  // makes the columns agree
      OpenColumn with = open_column(file, other);
      with.dims[0] = open.dims[0];
      H5Dset_extent(with.set, with.dims.data());
      H5Dclose(with.set);
    }
  });
  return {"2^" + std::to_string(bits) + " rows more in " + column.path, led_to_by_offsets(column)};
}

Forgery other_type(const std::string& path, ForgingChance& chance) {
  const Column& column = chance.any_column();
  const std::size_t way = chance.below(7);
  change_library(path, [&](hid_t file) {
    const hid_t type = type_of_way(way, column);
    const OpenColumn open = open_column(file, column);
    const hid_t space = H5Dget_space(open.set);  // this space may grow, as required by chunks larger than the data set
    H5Dclose(open.set);
    const hid_t properties = H5Pcreate(H5P_DATASET_CREATE);
    H5Pset_chunk(properties, int(open.chunk.size()), open.chunk.data());
    H5Pset_fletcher32(properties);
    declare_anew(file, column, type, space, properties);
    H5Pclose(properties);
    H5Sclose(space);
    H5Tclose(type);
  });
  return {"type of way " + std::to_string(way) + " in " + column.path};
}

Forgery other_layout(const std::string& path, ForgingChance& chance) {
  const Column& column = chance.any_column();
  const std::size_t way = chance.below(4);
  change_library(path, [&](hid_t file) {
    const OpenColumn open = open_column(file, column);
    const hid_t type = H5Dget_type(open.set);
    H5Dclose(open.set);
    const hid_t space = H5Screate_simple(int(open.dims.size()), open.dims.data(), nullptr);
    const hid_t properties = H5Pcreate(H5P_DATASET_CREATE);
    if (way == 0) H5Pset_layout(properties, H5D_CONTIGUOUS);
    if (way == 1) H5Pset_layout(properties, H5D_COMPACT);
    if (way == 2) H5Pset_external(properties, "/dev/zero", 0, H5F_UNLIMITED);
    if (way == 3) H5Pset_virtual(properties, space, "/dev/zero", column.path.c_str(), space);
    declare_anew(file, column, type, space, properties);
    H5Pclose(properties);
    H5Sclose(space);
    H5Tclose(type);
  });
  return {"layout of way " + std::to_string(way) + " of " + column.path, is_new(column)};
}

Forgery other_link(const std::string& path, ForgingChance& chance) {
  const Column& column = chance.any_column();
  const Column& other = chance.any_column();
  const std::size_t way = chance.below(5);
  change_library(path, [&](hid_t file) {
    const char* name = column.path.c_str();
    H5Ldelete(file, name, H5P_DEFAULT);
    if (way == 1) H5Lcreate_soft("/field/scale", file, name, H5P_DEFAULT, H5P_DEFAULT);
    if (way == 2) H5Lcreate_external("/dev/zero", "/x", file, name, H5P_DEFAULT, H5P_DEFAULT);
    if (way == 3) H5Lcreate_hard(file, other.path.c_str(), file, name, H5P_DEFAULT, H5P_DEFAULT);
    if (way == 4) H5Gclose(H5Gcreate2(file, name, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT));
  });
  return {"link of way " + std::to_string(way) + " for " + column.path + " (" + other.path + ")",
          (way == 0 && is_new(column)) || way == 3};
}

Forgery forged_attribute(const std::string& path, ForgingChance& chance) {
  const char* names[] = {"format", "version", "pad_levels", "pad_delta_tau_rad"};
  const char* name = names[chance.below(4)];
  const std::size_t way = chance.below(4);
  change_library(path, [&](hid_t file) {
    H5Adelete(file, name);
    if (way == 0) return;
    const hsize_t many = 5000;
    const hid_t space = way == 1 ? H5Screate_simple(1, &many, nullptr) : H5Screate(H5S_SCALAR);
    hid_t type = H5Tcopy(H5T_STD_I32LE);
    if (way == 2) H5Tset_size(type = H5Tcopy(H5T_C_S1), H5T_VARIABLE);
    const hid_t made = H5Acreate2(file, name, type, space, H5P_DEFAULT, H5P_DEFAULT);
    if (way == 3) {
      const int value = int(chance.bits());
      H5Awrite(made, H5T_NATIVE_INT, &value);
    }
    H5Aclose(made);
    H5Tclose(type);
    H5Sclose(space);
  });
  return {std::string("attribute ") + name + " of way " + std::to_string(way)};
}

}  // namespace tessera::test
