// The program's exceptions as the package's one.
#pragma once

#include <exception>
#include <new>
#include <utility>

#include "tessera/matching/error.h"

namespace tessera::matching {

/// Returns what `work` returns. Whatever it throws becomes an Error; a lack of memory stays std::bad_alloc.
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
