// The secret in the address of a served page.
#pragma once

#include <string>
#include <string_view>

namespace tessera::serve {

/// 32 hexadecimal digits, of 128 bits that the system's generator made. Throws EnvironmentError.
std::string random_token();

/// Whether both are the same. The time that it takes does not tell where they differ.
bool same_token(std::string_view a, std::string_view b);

}  // namespace tessera::serve
