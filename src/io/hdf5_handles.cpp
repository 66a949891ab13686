#include "io/hdf5_handles.h"

namespace tessera::io {
namespace {

herr_t keep_description(unsigned, const H5E_error2_t* entry, void* text) {
  if (entry->desc != nullptr) *static_cast<std::string*>(text) = entry->desc;
  return 0;
}

}  // namespace

void prepare_hdf5() {
  [[maybe_unused]] static const herr_t once = H5dont_atexit();
}

std::string last_hdf5_message() {
  std::string text = "unknown HDF5 error";
  H5Ewalk2(H5E_DEFAULT, H5E_WALK_DOWNWARD, keep_description, &text);  // outermost first: the innermost stays
  for (char& c : text) {
    if (c == '\n') c = ' ';
  }
  return text;
}

}  // namespace tessera::io
