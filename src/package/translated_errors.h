// Turns the program's exceptions into the package's one exception.
#pragma once

#include <exception>
#include <new>
#include <utility>

#include "tessera/matching/error.h"

namespace tessera::matching {

/// Returns the result of `work`. Whatever it throws becomes an Error; only std::bad_alloc stays as it is.
template <class Work>
decltype(auto) with_errors_translated(Work&& work) {
  try {
    return std::forward<Work>(work)();
  } catch (const Error&) {
    throw;
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& error) {
    throw Error(error.what());
  }
}

}  // namespace tessera::matching
