// Text of any bytes for files that programs read.
#pragma once

#include <string>

namespace tessera {

/// The name of a file or folder as a JSON text, in quotes and in ASCII. A byte that is not part of valid UTF-8 becomes
/// a lone surrogate, U+DC80 to U+DCFF; os.fsencode of Python turns it back into the byte.
std::string json_path_text(const std::string& path);

}  // namespace tessera
