#include "files/file_descriptor.h"

#include <unistd.h>

namespace tessera {

bool FileDescriptor::close() {
  const int number = std::exchange(number_, -1);
  return number < 0 || ::close(number) == 0;
}

}  // namespace tessera
