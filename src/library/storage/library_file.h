// The library: many shapes in one HDF5 file (docs/library-format.md). Reading a range of shapes touches only the chunks
// that hold it, so that each rank reads its own part.
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

/// The data that `tessera library info` shows. No shapes are read for it.
struct LibrarySummary {
  std::size_t shapes = 0;
  std::size_t curves = 0;  // outer curves and holes of outlines
  std::size_t outline_points = 0;
  std::uint64_t original_bytes = 0;  // embedded artwork; 0 without --embed
  std::uint64_t file_bytes = 0;
  std::vector<std::pair<std::string, std::uint64_t>> stored_bytes_of_part;  // compressed, as in the file
};

/// Fields are read within 0.0005 shape units of what was written, all other data to the bit. Not for use by several threads
/// at once.
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
  /// Reads some hundred bytes for each shape: the digest of its outline, field and levels is stored. read() compares all
  /// that it reads with this digest, so that a wrong digest is found before the part is used. Libraries of older versions
  /// store no digest and are read as a whole.
  std::uint64_t content_digest() const override;
  /// Libraries of older versions know no variants: each shape is its own.
  std::vector<std::uint32_t> variant_of() const override;
  /// Unknown in libraries of older versions.
  std::vector<StyleFeatures> styles() const override;
  bool has_surroundings() const override;
  /// Each shape itself, because a file holds no mirror images.
  std::vector<std::uint32_t> drawings() const override;
  /// The heads of the shapes [begin, end). Throws as read().
  std::vector<ShapeHead> heads(std::size_t begin, std::size_t end) const;
  std::vector<Shape> read(std::size_t begin, std::size_t end, const LibraryParts& parts) const override;
  /// Null for libraries of older versions, which hold no models.
  std::shared_ptr<const ModelSource> stored_models(const MatchingContext& context) const override;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// Writes path + ".tmp" and renames it, so that a reader never sees half a library and a failure leaves none. Throws
/// EnvironmentError where the file cannot be written.
class LibraryWriter {
 public:
  LibraryWriter(const std::string& path, const PadParameters& pad);
  ~LibraryWriter();  // unfinished: removes the temporary file
  /// `variant_of`: the first shape of the library with the same silhouette; empty: this is the first one. Throws InputError
  /// where the shape breaks a limit of the format, before anything of it is written.
  void append(const Shape& shape, std::optional<std::uint32_t> variant_of = {}, const StyleFeatures& style = {});
  void finish();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace tessera
