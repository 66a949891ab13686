// Numbers as text: the same bytes in every locale, and never "-0.000".
#pragma once

#include <string>

namespace tessera {

/// The number with this many decimals: fixed(2, 3) == "2.000". Not-a-number and infinity become 0: no file format here
/// can write them.
std::string fixed(double value, int decimals);

/// The number with this many significant digits, without trailing zeros: significant(0.0012345, 3) == "0.00123". Very
/// large and very small numbers have an exponent. Not-a-number and infinity become 0.
std::string significant(double value, int digits);

/// The number rounded to this many decimals, for JSON.
double rounded(double value, int decimals);

}  // namespace tessera
