// What an InputError says, for tests of messages.
#pragma once

#include <functional>
#include <string>

#include "core/base/error.h"

namespace tessera::test {

/// Empty where `action` throws none.
inline std::string message_of(const std::function<void()>& action) {
  try {
    action();
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

}  // namespace tessera::test
