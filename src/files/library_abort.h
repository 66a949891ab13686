// Handles a library that ends the process by abort(3) or exit(3), as OpenCL's compiler does when memory or a file is
// limited.
#pragma once

namespace tessera {

/// While it lives, such an end removes leftover files (files/leftover_file.h) and prints the limits of the process, if
/// there are any: the library's own message seldom names them. At most one object at a time.
class LibraryAbortHandler {
 public:
  LibraryAbortHandler();
  ~LibraryAbortHandler();
  LibraryAbortHandler(const LibraryAbortHandler&) = delete;
  LibraryAbortHandler& operator=(const LibraryAbortHandler&) = delete;
};

/// Sets the handler of abort(3) again while a LibraryAbortHandler lives. To be called when kernels are compiled, as LLVM
/// installs a handler of its own.
void set_abort_handler_again();

}  // namespace tessera
