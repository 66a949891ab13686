#include "library/hdf5/hdf5_attributes.h"

namespace tessera {
namespace {

constexpr std::size_t kMaxTextBytes = 1000;

void write_scalar(hid_t object, const std::string& name, hid_t file_type, hid_t memory_type, const void* value) {
  const std::string what = "attribute " + name;
  const Hdf5Handle space(H5Screate(H5S_SCALAR), what);
  const Hdf5Handle attribute(H5Acreate2(object, name.c_str(), file_type, space.get(), H5P_DEFAULT, H5P_DEFAULT), what);
  hdf5_checked(H5Awrite(attribute.get(), memory_type, value), what);
}

Hdf5Handle open_scalar(hid_t object, const std::string& name) {
  const std::string what = "attribute " + name;
  if (hdf5_checked(H5Aexists(object, name.c_str()), what) == 0) throw Hdf5Error(what + " is missing");
  Hdf5Handle attribute(H5Aopen(object, name.c_str(), H5P_DEFAULT), what);
  const Hdf5Handle space(H5Aget_space(attribute.get()), what);
  if (H5Sget_simple_extent_type(space.get()) != H5S_SCALAR) throw Hdf5Error(what + " is not a scalar");
  return attribute;
}

void read_scalar(hid_t object, const std::string& name, hid_t file_type, hid_t memory_type, void* value) {
  const std::string what = "attribute " + name;
  const Hdf5Handle attribute = open_scalar(object, name);
  const Hdf5Handle type(H5Aget_type(attribute.get()), what);
  if (H5Tequal(type.get(), file_type) <= 0) throw Hdf5Error(what + " is of a wrong type");
  hdf5_checked(H5Aread(attribute.get(), memory_type, value), what);
}

}  // namespace

void write_attribute(hid_t object, const std::string& name, int value) {
  write_scalar(object, name, H5T_STD_I32LE, H5T_NATIVE_INT, &value);
}

void write_attribute(hid_t object, const std::string& name, float value) {
  write_scalar(object, name, H5T_IEEE_F32LE, H5T_NATIVE_FLOAT, &value);
}

void write_attribute(hid_t object, const std::string& name, const std::string& value) {
  const Hdf5Handle type(H5Tcopy(H5T_C_S1), name);
  hdf5_checked(H5Tset_size(type.get(), value.size() + 1), name);
  hdf5_checked(H5Tset_strpad(type.get(), H5T_STR_NULLTERM), name);
  hdf5_checked(H5Tset_cset(type.get(), H5T_CSET_UTF8), name);
  write_scalar(object, name, type.get(), type.get(), value.c_str());
}

int read_int_attribute(hid_t object, const std::string& name) {
  int value = 0;
  read_scalar(object, name, H5T_STD_I32LE, H5T_NATIVE_INT, &value);
  return value;
}

float read_float_attribute(hid_t object, const std::string& name) {
  float value = 0;
  read_scalar(object, name, H5T_IEEE_F32LE, H5T_NATIVE_FLOAT, &value);
  return value;
}

std::string read_text_attribute(hid_t object, const std::string& name) {
  const std::string what = "attribute " + name;
  const Hdf5Handle attribute = open_scalar(object, name);
  const Hdf5Handle type(H5Aget_type(attribute.get()), what);
  const std::size_t size = H5Tget_size(type.get());
  if (H5Tget_class(type.get()) != H5T_STRING || H5Tis_variable_str(type.get()) != 0 || size > kMaxTextBytes) {
    throw Hdf5Error(what + " is not a short text of fixed length");
  }
  std::string value(size, '\0');
  hdf5_checked(H5Aread(attribute.get(), type.get(), value.data()), what);
  return value.substr(0, value.find('\0'));
}

}  // namespace tessera
