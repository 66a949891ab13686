// Errors that a user can cause and fix. Every other exception is a bug.
#pragma once

#include <stdexcept>

namespace tessera {

/// Bad input: a file, a key, an argument. The message is one line and names the file, the key, the value found and the
/// allowed values. The program ends with exit code 2.
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
