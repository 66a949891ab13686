// Several library files as one library, or a choice of their shapes: nothing is copied.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/colour/lab.h"
#include "library/mirroring.h"
#include "library/name_globs.h"
#include "library/storage/library_file.h"
#include "library/storage/shape_library.h"

namespace tessera {

struct NoSuchColours : InputError {
  using InputError::InputError;
};

/// Drawings that are so near to a palette.
struct ColourChoice {
  std::vector<Lab> palette;    // empty: all drawings
  float most_difference = 15;  // CIEDE2000 (core/colour/palette_difference.h)
};

/// Drawings of a style. All of them where no name is given.
struct StyleChoice {
  std::vector<std::string> like = {};       // style_reference.h, by the names in the files
  std::optional<std::size_t> closest = {};  // so many, 1 at least
  std::optional<float> within = {};         // a distance (core/style/style_features.h)
};

struct LibraryChoice {
  std::vector<std::string> files;             // one at least
  NameGlobs names;                            // as they are in the files
  std::vector<MirroringRule> mirroring = {};  // by the names of the view; of several the last one holds; none: never
  bool drawn_sizes = false;                   // content_digest() tells libraries apart whose drawings' sizes differ
  ColourChoice colours = {};
  bool styles = false;  // content_digest() tells libraries apart whose drawings' styles differ
  StyleChoice style = {};
};

/// The shapes come in the order of the files, and in a file's order, then mirror images under the names of their
/// shapes. A shape that may stand mirrored only is its mirror image from the start. Of several files those shapes are
/// left out that have outline and colour of an earlier one, as `tessera library build` does; shapes of one outline in
/// other colours are variants of the first. A name that was there already gets the folder of the artwork, and a number.
class LibraryView : public ShapeLibrary {
 public:
  struct Twin {
    std::string path;  // of the file
    std::string name;  // in it
    std::string kept;  // the name of the shape that stands for it
  };

  /// Throws InputError as LibraryFile does; where the files were built with different parameters; where the choice is
  /// empty (NoSuchColours where by colours); and where a file does not know its drawings' colours and they are asked for.
  explicit LibraryView(const LibraryChoice& choice);

  const std::string& path() const override { return path_; }
  std::size_t size() const override { return whole_file() ? files_.front().size() : entries_.size(); }
  PadParameters pad_parameters() const override { return files_.front().pad_parameters(); }
  std::uint64_t content_digest() const override;
  std::vector<std::uint32_t> variant_of() const override;
  std::vector<StyleFeatures> styles() const override;
  std::vector<std::uint32_t> drawings() const override;
  std::vector<Shape> read(std::size_t begin, std::size_t end, const LibraryParts& parts) const override;
  /// Of one file as a whole.
  std::shared_ptr<const ModelSource> stored_models(const MatchingContext& context) const override;

  /// Of the shapes [begin, end).
  std::vector<ShapeHead> heads(std::size_t begin, std::size_t end) const;

  /// The names in the files, of all their shapes, chosen or not.
  std::vector<std::string> names_in_files() const;

  /// What was left out for being there already.
  const std::vector<Twin>& twins() const { return twins_; }

 private:
  struct Entry {
    std::uint32_t file;
    std::uint32_t index;  // in the file
    std::uint32_t variant_of;
    std::string new_name;  // empty: as in the file
    bool mirrored = false;
    std::uint32_t drawing = 0;  // the entry that it is the mirror image of, mostly itself
  };
  class Gathering;

  void gather(const LibraryChoice& choice);
  void add_mirror_images(const std::vector<MirroringRule>& rules);

  bool whole_file() const { return entries_.empty(); }
  std::size_t run_end(std::size_t begin, std::size_t end) const;
  std::vector<std::string> names() const;
  std::vector<float> drawn_scales_px() const;

  std::vector<LibraryFile> files_;
  std::string path_;
  std::vector<Entry> entries_;  // empty: all of the only file
  bool drawn_sizes_;
  bool styles_;
  std::vector<Twin> twins_;
};

}  // namespace tessera
