// The colour difference CIEDE2000 (CIE 142; Sharma, Wu, Dalal 2005); a difference of 1 is just visible. It affects the
// picture, so it uses + - * / and sqrt only: hues are unit vectors, never angles. kernels/colour.cl computes the same,
// bit for bit.
#pragma once

#include "core/colour/lab.h"

namespace tessera {

float ciede2000(const Lab& x, const Lab& y);

}  // namespace tessera
