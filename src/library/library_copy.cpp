#include "library/library_copy.h"

#include <cstdint>
#include <vector>

#include "library/storage/library_file.h"

namespace tessera {

void copy_library(const ShapeLibrary& library, const std::string& output,
                  const std::function<void(std::size_t)>& done) {
  const LibraryParts everything{
      .outline = true, .field = true, .levels = ~0u, .artwork = true, .original = true, .surroundings = true};
  const std::vector<std::uint32_t> variant_of = library.variant_of();
  const std::vector<StyleFeatures> styles = library.styles();
  LibraryWriter writer(output, library.pad_parameters());
  for (std::size_t i = 0; i < library.size(); ++i) {
    writer.append(library.read(i, i + 1, everything).front(), variant_of[i], styles[i]);
    done(i + 1);
  }
  writer.finish();
}

}  // namespace tessera
