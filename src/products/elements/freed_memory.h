// Gives freed memory back to the system between two steps that take much of it; otherwise the program keeps it
// (program/run_main.cpp).
#pragma once

#include <malloc.h>

namespace tessera {

inline void give_back_freed_memory() { malloc_trim(0); }

}  // namespace tessera
