// Texts of any bytes in files that programs read.
#pragma once

#include <string>

namespace tessera {

/// The name of a file or folder as a JSON text, in quotes and in ASCII. JSON has no bytes: one that belongs to no UTF-8
/// becomes a lone surrogate, from U+DC80 to U+DCFF, which os.fsencode of Python makes the byte again.
std::string json_path_text(const std::string& path);

}  // namespace tessera
