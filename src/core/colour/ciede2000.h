// The colour difference CIEDE2000 (CIE 142; Sharma, Wu, Dalal 2005), 1 being about what the eye just sees. It decides,
// so it is made of + - * / and sqrt alone: hues are unit vectors, never angles. kernels/colour.cl is the same, bit for
// bit.
#pragma once

#include "core/colour/lab.h"

namespace tessera {

float ciede2000(const Lab& x, const Lab& y);

}  // namespace tessera
