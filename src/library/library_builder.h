// Builds a library file from artwork files. Every drawing is traced in a process with limits (drawers.h), so that none can
// hang or crash the build. Results are taken in the order of the files, so that the library's bytes do not depend on
// timing.
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
  bool embed = false;       // keep the bytes of the artwork files
  bool strict = false;      // write nothing where a file cannot be used
  bool keep_twins = false;  // files of the same silhouette and colour become separate shapes
  int files_at_a_time = 1;
};

struct LibraryBuildReport {
  struct Merged {
    std::string path;
    std::string name;  // of the kept shape with the same silhouette and mean colour
  };

  bool written = false;   // false: no shape, or `strict` and a file was not used
  std::size_t files = 0;  // shapes, merged and skipped files; a folder that cannot be listed counts as one
  std::size_t shapes = 0;
  std::vector<UnusedFile> skipped;
  std::vector<Merged> merged;
  // paths of shapes whose parts that do not touch the largest one were left out
  std::vector<std::string> trimmed;
  std::vector<std::string> first_pictures;  // paths of shapes made of the first of several pictures in the file
  std::vector<std::string> textless;        // paths of shapes without their text, because this machine has no font
  // paths of shapes whose parts that are too faint or too thin were left out
  std::vector<std::string> faint;
  std::vector<std::string> hollow;  // paths of shapes that TracingRules::fill_holes would help
};

struct ShapeLoader {
  /// Loads a file; called from several threads. Throws InputError where the file is no artwork.
  std::function<std::variant<ArtworkShape, SkipReason>(const std::string& path)> load;
  /// Makes all running loads throw soon.
  std::function<void()> stop = [] {};
};

/// A loader that calls Drawers::shape(). The drawers must outlive it.
ShapeLoader artwork_loader(Drawers& drawers, const TracingSettings& settings);

/// Called in the calling thread after each file.
using BuildProgress = std::function<void(std::size_t files_done, std::size_t shapes)>;

/// Writes the library at `output`, whole or not at all. Throws EnvironmentError where the file cannot be written.
LibraryBuildReport build_library(const ArtworkFiles& files, const std::string& output,
                                 const LibraryBuildSettings& settings, const ShapeLoader& loader,
                                 const BuildProgress& progress);

}  // namespace tessera
