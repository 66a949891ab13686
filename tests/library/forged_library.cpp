#include "forged_library.h"

#include <filesystem>
#include <fstream>
#include <iterator>

#include "forged_chunks.h"
#include "forged_declarations.h"
#include "forged_numbers.h"

namespace tessera::test {
namespace {

Forgery cut(const std::string& path, ForgingChance& chance) {
  const auto size = std::filesystem::file_size(path);
  const auto left = size * chance.below(1000) / 1000;
  std::filesystem::resize_file(path, left);
  return {"cut to " + std::to_string(left) + " of " + std::to_string(size) + " bytes"};
}

/// Changes bytes anywhere in the file. A change in unused bytes has no effect.
Forgery flipped_bytes(const std::string& path, ForgingChance& chance) {
  std::fstream file(path, std::ios::binary | std::ios::in | std::ios::out);
  const auto size = std::filesystem::file_size(path);
  for (std::size_t i = 1 + chance.below(8); i > 0; --i) {
    file.seekp(std::streamoff(chance.below(2) == 0 ? chance.below(8192) : chance.below(size)));
    file.put(char(chance.bits()));
  }
  return {"some bytes of the file"};
}

constexpr Forgery (*kForgeries[])(const std::string&, ForgingChance&) = {
    chunk_that_inflates_to_less,
    chunk_that_inflates_to_more,
    chunk_with_skipped_filters,
    chunk_of_random_bytes,
    other_filters,
    giant,
    other_type,
    other_layout,
    other_link,
    absurd_number,
    flipped_content,
    astray_offset,
    forged_thumbnail,
    forged_attribute,
    cut,
    flipped_bytes,
};

}  // namespace

Forgery forge_library(const std::string& path, std::uint32_t seed) {
  ForgingChance chance(seed);
  return kForgeries[seed % std::size(kForgeries)](path, chance);
}

}  // namespace tessera::test
