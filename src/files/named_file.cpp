#include "files/named_file.h"

#include <fcntl.h>
#include <sys/stat.h>

namespace tessera {

bool leads_to(int folder, const std::string& name, const FileDescriptor& file) {
  struct stat opened {};
  struct stat named {};
  return ::fstat(file.number(), &opened) == 0 && ::fstatat(folder, name.c_str(), &named, AT_SYMLINK_NOFOLLOW) == 0 &&
         opened.st_dev == named.st_dev && opened.st_ino == named.st_ino;
}

}  // namespace tessera
