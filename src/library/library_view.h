// Several library files as one library, or a choice of their shapes, without copying anything.
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

/// Chooses drawings whose colours are near to a palette.
struct ColourChoice {
  std::vector<Lab> palette;    // empty: all drawings
  float most_difference = 15;  // CIEDE2000 (core/colour/palette_difference.h)
};

/// Chooses drawings of a style. Without a name in `like` it chooses all.
struct StyleChoice {
  std::vector<std::string> like = {};       // names in the files that tell the style (style_reference.h)
  std::optional<std::size_t> closest = {};  // the number of drawings, at least 1
  std::optional<float> within = {};         // the largest distance (core/style/style_features.h)
};

struct LibraryChoice {
  std::vector<std::string> files;  // one at least
  NameGlobs names;                 // names in the files
  // by names in the view; the last rule for a name holds; without rules no shape is mirrored
  std::vector<MirroringRule> mirroring = {};
  bool drawn_sizes = false;  // content_digest() depends on the sizes of drawings
  ColourChoice colours = {};
  bool styles = false;  // content_digest() depends on the styles of drawings
  StyleChoice style = {};
};

/// Shapes come in the order of the files, and of their place in a file; mirror images follow, under the names of their
/// shapes. A shape that may only stand mirrored is replaced by its mirror image. Of several files, a shape with outline and
/// colour of an earlier shape is left out, as `tessera library build` does. Shapes of one outline in other colours are
/// variants of the first. A repeated name gets the folder of the artwork, and a number.
class LibraryView : public ShapeLibrary {
 public:
  struct Twin {
    std::string path;  // path of the file
    std::string name;  // name in that file
    std::string kept;  // name of the shape that is used instead
  };

  /// Throws InputError like LibraryFile. Also throws it where files were built with different parameters, where the choice
  /// is empty (NoSuchColours, if because of colours), and where colours are asked for that a file does not know.
  explicit LibraryView(const LibraryChoice& choice);

  const std::string& path() const override { return path_; }
  std::size_t size() const override { return whole_file() ? files_.front().size() : entries_.size(); }
  PadParameters pad_parameters() const override { return files_.front().pad_parameters(); }
  std::uint64_t content_digest() const override;
  std::vector<std::uint32_t> variant_of() const override;
  std::vector<StyleFeatures> styles() const override;
  bool has_surroundings() const override;
  std::vector<std::uint32_t> drawings() const override;
  std::vector<Shape> read(std::size_t begin, std::size_t end, const LibraryParts& parts) const override;
  /// The stored models, if the view is one whole file.
  std::shared_ptr<const ModelSource> stored_models(const MatchingContext& context) const override;

  /// The heads of the shapes [begin, end).
  std::vector<ShapeHead> heads(std::size_t begin, std::size_t end) const;

  /// The names of all shapes in the files, chosen or not.
  std::vector<std::string> names_in_files() const;

  /// The shapes that were left out because an earlier one is the same.
  const std::vector<Twin>& twins() const { return twins_; }

 private:
  struct Entry {
    std::uint32_t file;
    std::uint32_t index;  // number in the file
    std::uint32_t variant_of;
    std::string new_name;  // empty: the name in the file
    bool mirrored = false;
    std::uint32_t drawing = 0;  // the entry whose mirror image it is, mostly itself
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
  std::vector<Entry> entries_;  // empty: all shapes of the only file
  bool drawn_sizes_;
  bool styles_;
  std::vector<Twin> twins_;
};

}  // namespace tessera
