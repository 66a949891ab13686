// Errors that a user can cause and mend. Everything else is a bug and throws something else.
#pragma once

#include <stdexcept>

namespace tessera {

/// Bad input: a file, a key, an argument. The message is one line and names the file, the key, what was found and what
/// is allowed. The program ends with exit code 2.
class InputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The machine failed: the disk is full, a permission or a device is missing. The program ends with exit code 1.
class EnvironmentError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace tessera
