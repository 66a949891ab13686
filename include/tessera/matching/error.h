/// @file
/// The one exception that the library throws.
#pragma once

#include <stdexcept>

#include "tessera/matching/export.h"

namespace tessera::matching {

/// Input that is of no use, or a machine that failed. The message is one line and names what was found and what is
/// allowed. Besides it only `std::bad_alloc` leaves a function of the library, and what a Descriptor of yours throws.
class TESSERA_MATCHING_API Error : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
  Error(const Error&) = default;
  Error& operator=(const Error&) = default;
  ~Error() override;
};

}  // namespace tessera::matching
