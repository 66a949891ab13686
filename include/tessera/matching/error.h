/// @file
/// The only exception type that the library throws.
#pragma once

#include <stdexcept>

#include "tessera/matching/export.h"

namespace tessera::matching {

/// Reports unusable input or a failure of the machine. The message is one line and names what was found and what is
/// allowed. Functions of the library throw nothing else but `std::bad_alloc`, and what your own Descriptor throws.
class TESSERA_MATCHING_API Error : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
  Error(const Error&) = default;
  Error& operator=(const Error&) = default;
  ~Error() override;
};

}  // namespace tessera::matching
