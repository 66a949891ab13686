// Reads the message of an InputError, for tests of messages.
#pragma once

#include <functional>
#include <string>

#include "core/base/error.h"

namespace tessera::test {

/// Returns the message, or an empty text if `action` throws no InputError.
inline std::string message_of(const std::function<void()>& action) {
  try {
    action();
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

}  // namespace tessera::test
