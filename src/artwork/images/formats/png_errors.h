// Error handling of our calls of libpng: silent, by longjmp. Between setjmp and such a call there must be nothing that
// needs a destructor.
#pragma once

#include <png.h>

#include <csetjmp>

namespace tessera {

[[noreturn]] inline void leave_png(png_structp png, png_const_charp) { std::longjmp(png_jmpbuf(png), 1); }
inline void ignore_png(png_structp, png_const_charp) {}

}  // namespace tessera
