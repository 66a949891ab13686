#include "library/library_names.h"

#include <cstddef>
#include <filesystem>

#include "text/utf8_text.h"

namespace tessera {
namespace {

constexpr std::size_t kMaxStemBytes = 160;  // with folder and number less than layout::kNameBytes
constexpr std::size_t kMaxFolderBytes = 60;

}  // namespace

std::string LibraryNames::unique(const std::string& stem, const std::string& path) {
  std::string name = cut_utf8(printable_utf8(stem), kMaxStemBytes);
  if (name.empty()) name.push_back('_');
  if (given_.insert(name).second) return name;
  const std::string folder = std::filesystem::path(path).parent_path().filename();
  name += " (" + cut_utf8(printable_utf8(folder), kMaxFolderBytes) + ")";
  if (given_.insert(name).second) return name;
  for (int number = 2;; ++number) {
    const std::string numbered = name + " " + std::to_string(number);
    if (given_.insert(numbered).second) return numbered;
  }
}

}  // namespace tessera
