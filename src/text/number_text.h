// Numbers as text: the same bytes in every locale, without "-0.000".
#pragma once

#include <string>

namespace tessera {

/// The number with so many decimals, e.g. fixed(2, 3) == "2.000". Not-a-number and infinity, which no format here has,
/// become 0.
std::string fixed(double value, int decimals);

/// The number with so many digits that count, without trailing zeros: significant(0.0012345, 3) == "0.00123". Numbers that
/// are very large or small have an exponent. Not-a-number and infinity become 0.
std::string significant(double value, int digits);

/// The number rounded to so many decimals, for JSON.
double rounded(double value, int decimals);

}  // namespace tessera
