// The shapes of a run, wherever they lie: one library file (library_file.h) or a choice from several (library_view.h).
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "core/matching/model_source.h"
#include "core/shape/shape.h"
#include "core/style/style_features.h"

namespace tessera {

/// Which parts of the shapes to read; the others stay empty. Names, perimeters, radii and colours always come.
struct LibraryParts {
  bool outline = true;
  bool field = true;
  std::uint32_t levels = ~0u;  // bit k: smoothing level k
  bool artwork = true;         // path, geometry and thumbnail
  bool original = false;       // the embedded files
};

class ShapeLibrary {
 public:
  virtual ~ShapeLibrary() = default;

  /// For messages: the file, or the files.
  virtual const std::string& path() const = 0;
  virtual std::size_t size() const = 0;
  virtual PadParameters pad_parameters() const = 0;
  /// A digest of all that decides about a collage: PAD parameters, names, lengths, colours, outlines, fields, smoothing
  /// levels, in their order, and which shapes are variants; artwork does not count. Two libraries with the same digest
  /// give the same collage, wherever they lie. Throws as read().
  virtual std::uint64_t content_digest() const = 0;
  /// For each shape the first one with the same silhouette, in other colours; mostly itself. Throws as read().
  virtual std::vector<std::uint32_t> variant_of() const = 0;
  /// What each shape's drawing looks like; unknown in libraries of older versions. Throws as read().
  virtual std::vector<StyleFeatures> styles() const = 0;
  /// For each shape the one that it is the mirror image of: the same drawing, mirrored. Mostly itself.
  virtual std::vector<std::uint32_t> drawings() const = 0;
  /// Shapes [begin, end). Throws InputError that names file and data set where what is read is damaged.
  virtual std::vector<Shape> read(std::size_t begin, std::size_t end, const LibraryParts& parts) const = 0;
  /// The models as they lie in the file; nothing where they must be made of the shapes. The library outlives them.
  virtual std::shared_ptr<const ModelSource> stored_models(const MatchingContext&) const { return {}; }

 protected:
  ShapeLibrary() = default;
  ShapeLibrary(const ShapeLibrary&) = default;
  ShapeLibrary& operator=(const ShapeLibrary&) = default;
};

}  // namespace tessera
