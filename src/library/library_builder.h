// Builds a library file from artwork files. Every drawing is traced in a process with limits (drawers.h), so that none
// can hang or crash the build; results are taken in the order of the files, so that the library's bytes do not depend
// on timing.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <variant>
#include <vector>

#include "artwork/artwork_shape.h"
#include "artwork/drawers/drawers.h"
#include "core/shape/outline.h"
#include "library/artwork_files.h"

namespace tessera {

struct LibraryBuildSettings {
  TracingSettings tracing;
  bool embed = false;       // keep the artwork files' bytes
  bool strict = false;      // write nothing where a file cannot be used
  bool keep_twins = false;  // files of the same silhouette and colour are shapes of their own
  int files_at_a_time = 1;
};

struct LibraryBuildReport {
  struct Merged {
    std::string path;
    std::string name;  // of the shape with the same silhouette and mean colour that was kept
  };

  bool written = false;   // false: no shape, or strict and not all files were used
  std::size_t files = 0;  // shapes, merged and skipped; a folder that cannot be listed counts as one
  std::size_t shapes = 0;
  std::vector<UnusedFile> skipped;
  std::vector<Merged> merged;
  std::vector<std::string> trimmed;         // paths of shapes: parts that do not touch the largest one were left out
  std::vector<std::string> first_pictures;  // paths of shapes: of the file's first picture, as it has more
  std::vector<std::string> textless;        // paths of shapes: their text was not drawn, as this machine has no font
  std::vector<std::string> faint;           // paths of shapes: parts that are too faint or too thin were left out
  std::vector<std::string> hollow;          // paths of shapes that TracingRules::fill_holes would help
};

struct ShapeLoader {
  /// Called for each file, from several threads. Throws InputError where the file is no artwork.
  std::function<std::variant<ArtworkShape, SkipReason>(const std::string& path)> load;
  /// Makes all loads under way throw soon.
  std::function<void()> stop = [] {};
};

/// Drawers::shape of the file. The drawers must outlive the loader.
ShapeLoader artwork_loader(Drawers& drawers, const TracingSettings& settings);

/// Called after each file, in the calling thread.
using BuildProgress = std::function<void(std::size_t files_done, std::size_t shapes)>;

/// Writes the library at `output`, whole or not at all. Throws EnvironmentError where the file cannot be written.
LibraryBuildReport build_library(const ArtworkFiles& files, const std::string& output,
                                 const LibraryBuildSettings& settings, const ShapeLoader& loader,
                                 const BuildProgress& progress);

}  // namespace tessera
