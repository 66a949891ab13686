// A thin layer over the HDF5 C API: handles that close themselves, failures as exceptions, no printing.
#pragma once

#include <hdf5.h>

#include <stdexcept>
#include <string>
#include <utility>

#include "files/file_descriptor.h"

namespace tessera {

/// A failed HDF5 call or content that breaks the library format. Whoever knows the file's name turns it into an
/// InputError (reading) or EnvironmentError (writing).
class Hdf5Error : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// To be called before the first use of HDF5 in the process. HDF5's clean-up at exit crashes where a file could not be
/// flushed (disk full) or was damaged; we close all that we open, and need none.
void prepare_hdf5();

/// HDF5 prints its error stack on stderr by default; while this lives, the current thread does not.
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

/// What HDF5 says about the last failed call of this thread: its innermost message.
std::string last_hdf5_message();

/// Passes an id or status through. Throws Hdf5Error "<what>: <HDF5's message>" where it is negative.
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
  /// False where closing failed, which for a file means that its last bytes did not reach the disk.
  bool close() {
    const hid_t id = std::exchange(id_, H5I_INVALID_HID);
    return id < 0 || H5Idec_ref(id) >= 0;
  }

 private:
  hid_t id_ = H5I_INVALID_HID;
};

/// Another descriptor of the open file. Throws EnvironmentError where no descriptor is left.
FileDescriptor descriptor_of(hid_t file);

/// Every link on the way to an object must be a hard one: soft and external links could lead to other files. Throws
/// Hdf5Error, which begins with `what`.
void check_hard_links(hid_t file, const std::string& path, const std::string& what);

}  // namespace tessera
