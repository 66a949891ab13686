// PADs along an outline, as columns of numbers.
#pragma once

#include "arrays.h"

namespace tessera::python {

struct Pads {
  std::vector<matching::Pad> pads;
  int levels;

  Array positions() const;
  /// A row of levels for each PAD; a missing level is NaN.
  Array arclengths(std::vector<double> matching::Pad::*side) const;

  template <class Value>
  Array column(Value value) const {
    std::vector<double> numbers;
    for (const matching::Pad& pad : pads) numbers.push_back(value(pad));
    return array_of(numbers);
  }
};

}  // namespace tessera::python
