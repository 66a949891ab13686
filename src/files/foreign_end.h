// Where a library ends the process, by abort(3) or exit(3), as OpenCL's compiler does where memory or a file is limited.
#pragma once

namespace tessera {

/// While it lives such an end removes what must not stay (files/leftover_file.h), and tells of the limits of the process,
/// where it has any: the library's own words seldom name them. One object at a time.
class ForeignEnd {
 public:
  ForeignEnd();
  ~ForeignEnd();
  ForeignEnd(const ForeignEnd&) = delete;
  ForeignEnd& operator=(const ForeignEnd&) = delete;
};

/// Where a ForeignEnd lives: to be called when kernels are compiled, as LLVM takes the signal of abort(3) for itself.
void take_abort_again();

}  // namespace tessera
