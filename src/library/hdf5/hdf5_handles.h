// A thin layer over the HDF5 C API: handles that close themselves, failures as exceptions, no output on stderr.
#pragma once

#include <hdf5.h>

#include <stdexcept>
#include <string>
#include <utility>

#include "files/file_descriptor.h"

namespace tessera {

/// A failed HDF5 call, or content that breaks the library format. The caller that knows the file's name turns it into an
/// InputError (reading) or EnvironmentError (writing).
class Hdf5Error : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Prepares HDF5; to be called before its first use in the process. It switches off HDF5's clean-up at exit, which crashes
/// where a file could not be flushed (disk full) or was damaged. We close all that we open and need no clean-up.
void prepare_hdf5();

/// Keeps HDF5 from printing its error stack on stderr, for the current thread, while this object lives.
class Hdf5Silence {
 public:
  Hdf5Silence() {
    prepare_hdf5();
    H5Eget_auto2(H5E_DEFAULT, &printer_, &printer_data_);
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  }
  ~Hdf5Silence() { H5Eset_auto2(H5E_DEFAULT, printer_, printer_data_); }
  Hdf5Silence(const Hdf5Silence&) = delete;
  Hdf5Silence& operator=(const Hdf5Silence&) = delete;

 private:
  H5E_auto2_t printer_ = nullptr;
  void* printer_data_ = nullptr;
};

/// HDF5's innermost message about the last failed call of this thread.
std::string last_hdf5_message();

/// Returns `result`, an id or status. Where it is negative, throws Hdf5Error "<what>: <HDF5's message>".
template <class Result>
Result hdf5_checked(Result result, const std::string& what) {
  if (result < 0) throw Hdf5Error(what + ": " + last_hdf5_message());
  return result;
}

/// Owns one HDF5 identifier of any kind.
class Hdf5Handle {
 public:
  Hdf5Handle() = default;
  Hdf5Handle(hid_t id, const std::string& what) : id_(hdf5_checked(id, what)) {}
  ~Hdf5Handle() { close(); }
  Hdf5Handle(Hdf5Handle&& o) noexcept : id_(std::exchange(o.id_, H5I_INVALID_HID)) {}
  Hdf5Handle& operator=(Hdf5Handle&& o) noexcept {
    std::swap(id_, o.id_);
    return *this;
  }

  hid_t get() const { return id_; }
  /// Closes the identifier. False where that failed: for a file, its last bytes did not reach the disk.
  bool close() {
    const hid_t id = std::exchange(id_, H5I_INVALID_HID);
    return id < 0 || H5Idec_ref(id) >= 0;
  }

 private:
  hid_t id_ = H5I_INVALID_HID;
};

/// Another descriptor of the open file. Throws EnvironmentError where the process has no descriptor left.
FileDescriptor descriptor_of(hid_t file);

/// Checks that every link on the way to an object is a hard one, because soft and external links could lead to other files.
/// Throws Hdf5Error that begins with `what`.
void check_hard_links(hid_t file, const std::string& path, const std::string& what);

}  // namespace tessera
