// An open file of the system that closes itself.
#pragma once

#include <utility>

namespace tessera {

class FileDescriptor {
 public:
  /// Takes `number` over; a negative one is no file.
  explicit FileDescriptor(int number) : number_(number) {}
  ~FileDescriptor() { close(); }
  FileDescriptor(FileDescriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
  FileDescriptor& operator=(FileDescriptor&& other) noexcept {
    std::swap(number_, other.number_);
    return *this;
  }

  bool is_open() const { return number_ >= 0; }
  int number() const { return number_; }

  /// The number, for somebody else to close.
  int release() { return std::exchange(number_, -1); }

  /// False with errno where closing failed: network file systems report a full disk as late as here.
  bool close();

 private:
  int number_;
};

}  // namespace tessera
