// Handles a library that ends the process by abort(3) or exit(3), as OpenCL's compiler does when memory or a file is
// limited.
#pragma once

namespace tessera {

/// While it lives, such an end removes leftover files (files/leftover_file.h) and prints the limits of the process, if
/// there are any: the library's own message seldom names them. At most one object at a time.
class ForeignEnd {
 public:
  ForeignEnd();
  ~ForeignEnd();
  ForeignEnd(const ForeignEnd&) = delete;
  ForeignEnd& operator=(const ForeignEnd&) = delete;
};

/// Sets the handler of abort(3) again while a ForeignEnd lives. To be called when kernels are compiled, as LLVM
/// installs a handler of its own.
void take_abort_again();

}  // namespace tessera
