#include "library/hdf5/hdf5_handles.h"

#include <fcntl.h>

#include <algorithm>
#include <cerrno>
#include <string_view>
#include <system_error>

#include "core/base/error.h"

namespace tessera {
namespace {

herr_t keep_description(unsigned, const H5E_error2_t* entry, void* text) {
  if (entry->desc != nullptr) *static_cast<std::string*>(text) = entry->desc;
  return 0;
}

/// The system's own words in HDF5's long message about a failed system call, which has a time and a pointer in it.
std::string system_message_in(const std::string& text) {
  constexpr std::string_view kBefore = "error message = '";
  const std::size_t at = text.find(kBefore);
  if (at == std::string::npos) return text;
  const std::size_t begin = at + kBefore.size();
  return text.substr(begin, text.find('\'', begin) - begin);
}

}  // namespace

void prepare_hdf5() { [[maybe_unused]] static const herr_t once = H5dont_atexit(); }

std::string last_hdf5_message() {
  std::string text = "unknown HDF5 error";
  H5Ewalk2(H5E_DEFAULT, H5E_WALK_DOWNWARD, keep_description, &text);  // outermost first: the innermost stays
  std::replace(text.begin(), text.end(), '\n', ' ');
  return system_message_in(text);
}

FileDescriptor descriptor_of(hid_t file) {
  void* number = nullptr;
  hdf5_checked(H5Fget_vfd_handle(file, H5P_DEFAULT, &number), "file");
  FileDescriptor own(::fcntl(*static_cast<const int*>(number), F_DUPFD_CLOEXEC, 0));
  if (!own.is_open()) throw EnvironmentError("no file descriptor is left: " + std::generic_category().message(errno));
  return own;
}

void check_hard_links(hid_t file, const std::string& path, const std::string& what) {
  for (std::size_t slash = path.find('/', 1);; slash = path.find('/', slash + 1)) {
    const std::string prefix = path.substr(0, slash);
    H5L_info_t info{};
    if (H5Lexists(file, prefix.c_str(), H5P_DEFAULT) <= 0) throw Hdf5Error(what + " is missing");
    hdf5_checked(H5Lget_info(file, prefix.c_str(), &info, H5P_DEFAULT), what);
    if (info.type != H5L_TYPE_HARD) throw Hdf5Error(what + " is only a link");
    if (slash == std::string::npos) return;
  }
}

}  // namespace tessera
