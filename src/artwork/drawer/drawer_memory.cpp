// malloc and its relatives in tessera-drawer: without memory the process ends, and its exit code says so. Some
// libraries would go on and leave out parts, which nobody would notice in the picture.
#include <unistd.h>

#include <cerrno>
#include <cstddef>

#include "artwork/protocol/drawer_protocol.h"

// A sanitizer has an allocator of its own.
#ifndef __SANITIZE_ADDRESS__

extern "C" {

void* __libc_malloc(std::size_t bytes);
void* __libc_calloc(std::size_t count, std::size_t bytes);
void* __libc_realloc(void* block, std::size_t bytes);
void* __libc_memalign(std::size_t alignment, std::size_t bytes);

static void* there(void* block) {
  if (!block) ::_exit(tessera::kDrawerOutOfMemory);
  return block;
}

void* malloc(std::size_t bytes) { return there(__libc_malloc(bytes)); }

void* calloc(std::size_t count, std::size_t bytes) { return there(__libc_calloc(count, bytes)); }

void* realloc(void* block, std::size_t bytes) {
  void* moved = __libc_realloc(block, bytes);
  return bytes > 0 ? there(moved) : moved;  // after 0 bytes it was freed
}

void* memalign(std::size_t alignment, std::size_t bytes) { return there(__libc_memalign(alignment, bytes)); }

void* aligned_alloc(std::size_t alignment, std::size_t bytes) { return memalign(alignment, bytes); }

int posix_memalign(void** block, std::size_t alignment, std::size_t bytes) {
  if (alignment % sizeof(void*) != 0 || (alignment & (alignment - 1)) != 0) return EINVAL;
  *block = memalign(alignment, bytes);
  return 0;
}

}  // extern "C"

#endif
