// The library: many shapes in one HDF5 file (docs/library-format.md). Reading any range of shapes touches only the
// chunks that hold it, so that each rank reads its own part.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/shape/shape.h"
#include "library/storage/shape_head.h"
#include "library/storage/shape_library.h"

namespace tessera {

/// What `tessera library info` shows. No shapes are read for it.
struct LibrarySummary {
  std::size_t shapes = 0;
  std::size_t curves = 0;  // outlines' outer curves and holes
  std::size_t outline_points = 0;
  std::uint64_t original_bytes = 0;  // embedded artwork; 0 without --embed
  std::uint64_t file_bytes = 0;
  std::vector<std::pair<std::string, std::uint64_t>> stored_bytes_of_part;  // as they lie in the file, compressed
};

/// Fields come back within 0.0005 shape units of what was written, everything else to the bit. Not for use by several
/// threads at once.
class LibraryFile : public ShapeLibrary {
 public:
  /// Throws InputError where the file is missing, not HDF5, not a library, of another version, damaged or empty.
  explicit LibraryFile(const std::string& path);
  ~LibraryFile() override;
  LibraryFile(LibraryFile&&) noexcept;
  LibraryFile& operator=(LibraryFile&&) noexcept;

  const std::string& path() const override;
  std::size_t size() const override;
  PadParameters pad_parameters() const override;
  /// Throws as read().
  LibrarySummary summary() const;
  /// It costs some hundred bytes of reading a shape: the digest of a shape's outline, field and levels is stored, and
  /// read() compares with it all that it reads, so that a digest that lies is found before the part is used. Libraries
  /// of older versions, which have none stored, are read whole.
  std::uint64_t content_digest() const override;
  /// Libraries of older versions know none: each shape is its own.
  std::vector<std::uint32_t> variant_of() const override;
  /// Libraries of older versions know none.
  std::vector<StyleFeatures> styles() const override;
  /// A file holds no mirror images.
  std::vector<std::uint32_t> drawings() const override;
  /// What shapes [begin, end) are known by. Throws as read().
  std::vector<ShapeHead> heads(std::size_t begin, std::size_t end) const;
  std::vector<Shape> read(std::size_t begin, std::size_t end, const LibraryParts& parts) const override;
  /// Libraries of older versions hold none.
  std::shared_ptr<const ModelSource> stored_models(const MatchingContext& context) const override;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// Writes path + ".tmp", then renames: a reader never sees half a library, a failure leaves none.
/// Throws EnvironmentError where the file cannot be written.
class LibraryWriter {
 public:
  LibraryWriter(const std::string& path, const PadParameters& pad);
  ~LibraryWriter();  // unfinished: removes the temporary file
  /// `variant_of`: the first shape of the library with the same silhouette; nothing: this is the first one. Throws
  /// InputError where the shape breaks a limit of the format (before anything of it is written).
  void append(const Shape& shape, std::optional<std::uint32_t> variant_of = {}, const StyleFeatures& style = {});
  void finish();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace tessera
