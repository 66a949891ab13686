// The program keeps freed memory (program/run_main.cpp): between two steps that each take much of it, it is given back.
#pragma once

#include <malloc.h>

namespace tessera {

inline void give_back_freed_memory() { malloc_trim(0); }

}  // namespace tessera
