// The library: many shapes in one HDF5 file (docs/library-format.md). Reading any range of shapes touches only the
// chunks that hold it, so that each rank reads its own part.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "core/shape/shape.h"

namespace tessera::io {

/// Which parts of the shapes to read; the others stay empty. Names, perimeters, radii and colours always come.
struct LibraryParts {
  bool outline = true;
  bool field = true;
  std::uint32_t levels = ~0u;  // bit k: smoothing level k
  bool artwork = true;         // path, geometry and thumbnail
  bool original = false;       // the embedded files
};

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
class LibraryFile {
 public:
  /// Throws InputError where the file is missing, not HDF5, not a library, of another version, damaged or empty.
  explicit LibraryFile(const std::string& path);
  ~LibraryFile();
  LibraryFile(LibraryFile&&) noexcept;
  LibraryFile& operator=(LibraryFile&&) noexcept;

  const std::string& path() const;
  std::size_t size() const;
  PadParameters pad_parameters() const;
  /// Throws as read().
  LibrarySummary summary() const;
  /// A digest of all that decides about a collage: PAD parameters, names, lengths, colours, outlines, fields, smoothing
  /// levels, in their order; artwork does not count. Two libraries with the same digest give the same collage, wherever
  /// they lie. It costs some hundred bytes of reading a shape: the digest of a shape's outline, field and levels is
  /// stored, and read() compares with it all that it reads, so that a digest that lies is found before the part is
  /// used. Libraries of older versions, which have none stored, are read whole.
  std::uint64_t content_digest() const;
  /// Shapes [begin, end). Throws InputError that names the data set where what is read is damaged.
  std::vector<Shape> read(std::size_t begin, std::size_t end, const LibraryParts& parts) const;

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
  /// Throws InputError where the shape breaks a limit of the format (before anything of it is written).
  void append(const Shape& shape);
  void finish();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace tessera::io
