// One data set of a checkpoint: plain numbers in rows, without compression. Both ways throw Hdf5Error, which names it.
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

/// Makes the groups on the way. Number is std::uint8_t, std::int32_t, std::uint32_t, std::uint64_t, float or double.
template <class Number>
void write_array(hid_t file, const ArrayLayout& layout, const std::vector<Number>& numbers);

/// Refuses what write_array does not write: another type or shape, links, bytes outside the file, filters, and more
/// bytes than `budget_bytes`, from which those that were read are taken.
template <class Number>
std::vector<Number> read_array(hid_t file, const ArrayLayout& layout, std::uint64_t& budget_bytes);

}  // namespace tessera
