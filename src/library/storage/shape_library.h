// The shapes of a run: from one library file (library_file.h) or chosen from several (library_view.h).
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

/// The parts of shapes to read; other parts stay empty. Names, perimeters, radii and colours are always read.
struct LibraryParts {
  bool outline = true;
  bool field = true;
  std::uint32_t levels = ~0u;  // bit k: smoothing level k
  bool artwork = true;         // path, geometry and thumbnail
  bool original = false;       // the embedded files
  bool surroundings = false;   // what lies round drawings in their photos
};

class ShapeLibrary {
 public:
  virtual ~ShapeLibrary() = default;

  /// The file, or the files, for messages.
  virtual const std::string& path() const = 0;
  virtual std::size_t size() const = 0;
  virtual PadParameters pad_parameters() const = 0;
  /// A digest of all data that decide about a collage: PAD parameters, names, lengths, colours, outlines, fields and
  /// smoothing levels in their order, and which shapes are variants. Artwork does not count. Two libraries with the same
  /// digest give the same collage. Throws as read().
  virtual std::uint64_t content_digest() const = 0;
  /// The first shape with the same silhouette, perhaps in other colours, for each shape; mostly itself. Throws as read().
  virtual std::vector<std::uint32_t> variant_of() const = 0;
  /// The style of each shape's drawing; unknown in libraries of older versions. Throws as read().
  virtual std::vector<StyleFeatures> styles() const = 0;
  /// Whether any shape knows the photo that it was cut out of (Artwork::surroundings_png).
  virtual bool has_surroundings() const = 0;
  /// The shape whose mirror image it is (the same drawing, mirrored), for each shape; mostly itself.
  virtual std::vector<std::uint32_t> drawings() const = 0;
  /// The shapes [begin, end). Throws InputError that names file and data set where the data are damaged.
  virtual std::vector<Shape> read(std::size_t begin, std::size_t end, const LibraryParts& parts) const = 0;
  /// The models that the file holds; null where they must be made of the shapes. The library outlives them.
  virtual std::shared_ptr<const ModelSource> stored_models(const MatchingContext&) const { return {}; }

 protected:
  ShapeLibrary() = default;
  ShapeLibrary(const ShapeLibrary&) = default;
  ShapeLibrary& operator=(const ShapeLibrary&) = default;
};

}  // namespace tessera
