// A file descriptor of the system that closes itself.
#pragma once

#include <utility>

namespace tessera {

class FileDescriptor {
 public:
  /// Takes over the descriptor `number`; a negative number means no file.
  explicit FileDescriptor(int number) : number_(number) {}
  ~FileDescriptor() { close(); }
  FileDescriptor(FileDescriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
  FileDescriptor& operator=(FileDescriptor&& other) noexcept {
    std::swap(number_, other.number_);
    return *this;
  }

  bool is_open() const { return number_ >= 0; }
  int number() const { return number_; }

  /// Gives up the descriptor and returns its number; the caller must close it.
  int release() { return std::exchange(number_, -1); }

  /// False, with errno, where closing failed: network file systems may report a full disk only here.
  bool close();

 private:
  int number_;
};

}  // namespace tessera
