// One data set of a checkpoint: plain numbers in rows, without compression. Both functions throw Hdf5Error, which names
// the data set.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "library/hdf5/hdf5_handles.h"

namespace tessera {

struct ArrayLayout {
  std::string path;
  int row = 1;  // numbers in a row
  std::string units;
  std::string description;
};

/// Writes a data set and makes the groups of its path. Number is std::uint8_t, std::int32_t, std::uint32_t,
/// std::uint64_t, float or double.
template <class Number>
void write_array(hid_t file, const ArrayLayout& layout, const std::vector<Number>& numbers);

/// Reads a data set. Refuses what write_array does not write: another type or shape, links, bytes outside the file,
/// filters. Also refuses more bytes than `budget_bytes`; the bytes that were read are subtracted from it.
template <class Number>
std::vector<Number> read_array(hid_t file, const ArrayLayout& layout, std::uint64_t& budget_bytes);

}  // namespace tessera
