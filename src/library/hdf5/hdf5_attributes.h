// Scalar attributes of an HDF5 object. All functions throw Hdf5Error that names the attribute.
#pragma once

#include <string>

#include "library/hdf5/hdf5_handles.h"

namespace tessera {

void write_attribute(hid_t object, const std::string& name, int value);                 // 32-bit little-endian
void write_attribute(hid_t object, const std::string& name, float value);               // 32-bit IEEE little-endian
void write_attribute(hid_t object, const std::string& name, const std::string& value);  // fixed-length UTF-8

/// The attribute must be a scalar of the type that write_attribute() writes; a text has at most 1000 bytes.
int read_int_attribute(hid_t object, const std::string& name);
float read_float_attribute(hid_t object, const std::string& name);
std::string read_text_attribute(hid_t object, const std::string& name);

}  // namespace tessera
