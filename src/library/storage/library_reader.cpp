#include <algorithm>
#include <filesystem>
#include <numeric>
#include <optional>

#include "core/base/error.h"
#include "library/hdf5/hdf5_trial.h"
#include "library/storage/column_readers.h"
#include "library/storage/library_check.h"
#include "library/storage/library_file.h"
#include "library/storage/library_open.h"
#include "library/storage/segment_columns.h"
#include "library/storage/stored_models.h"

namespace tessera {
namespace {

constexpr std::size_t kBatchShapes = 64;  // limits the memory that is held twice while reading

bool is_one_of(const std::string& path, std::initializer_list<const layout::Column*> columns) {
  return std::any_of(columns.begin(), columns.end(), [&](const layout::Column* c) { return c->path == path; });
}

/// The result of `read`. A damaged file becomes an InputError that names the file.
template <class Read>
auto naming_the_file(const std::string& path, Read read) {
  const Hdf5Silence silence;
  try {
    return read();
  } catch (const Hdf5Error& error) {
    throw InputError(path + ": " + error.what());
  }
}

}  // namespace

struct LibraryFile::State {
  explicit State(const std::string& file_path)
      : path(file_path),
        file(open_library(file_path)),
        pad(read_library_header(file.get())),
        format(layout::library_columns(pad.levels)),
        head(file.get(), format),
        outline(file.get(), format),
        field(file.get(), format),
        artwork(file.get(), format, std::filesystem::absolute(file_path).parent_path()),
        original(file.get(), format.first_original_byte, format.original_bytes, layout::kMaxOriginalBytes),
        surroundings(file.get(), format),
        part_digest(ColumnReader::if_present(file.get(), format.part_digest)),
        variant_of(ColumnReader::if_present(file.get(), format.variant_of)),
        style(ColumnReader::if_present(file.get(), format.style)) {
    for (std::size_t k = 0; k < format.levels.size(); ++k) levels.emplace_back(file.get(), format.levels[k], k);
    check_rows();
    check_declared_bytes();
    segments = segment_places(file.get(), pad, std::uint32_t(head.shapes()));
    if (!segments.begins.empty()) bytes = std::make_shared<const FileDescriptor>(descriptor_of(file.get()));
  }

  std::vector<const ColumnReader*> columns() const;
  void check_rows() const;
  void check_declared_bytes() const;
  std::vector<PartDigests> stored_digests(std::size_t begin, std::size_t end) const;
  std::vector<PartDigests> digests(std::size_t begin, std::size_t end) const;
  std::vector<std::uint32_t> variants(std::size_t begin, std::size_t end) const;
  std::vector<StyleFeatures> styles(std::size_t begin, std::size_t end) const;
  std::vector<ShapeHead> heads(std::size_t begin, std::size_t end) const;
  LibrarySummary summary() const;
  std::vector<Shape> read(std::size_t begin, std::size_t end, const LibraryParts& parts) const;
  /// Returns the digests of what was read; they agree with the stored ones.
  std::vector<PartDigests> read_batch(const ShapeBatch& range, const LibraryParts& parts) const;

  std::string path;
  Hdf5Handle file;
  PadParameters pad;
  layout::Columns format;
  HeadReader head;
  OutlineReader outline;
  FieldReader field;
  ArtworkReader artwork;
  BytesReader original;
  SurroundingsReader surroundings;
  std::optional<ColumnReader> part_digest, variant_of, style;
  SegmentPlaces segments;
  std::shared_ptr<const FileDescriptor> bytes;  // of the open file, even if its name leads elsewhere by now
  std::vector<LevelReader> levels;
};

std::vector<const ColumnReader*> LibraryFile::State::columns() const {
  std::vector<const ColumnReader*> all;
  const auto add = [&](const std::vector<const ColumnReader*>& some) {
    all.insert(all.end(), some.begin(), some.end());
  };
  add(head.columns());
  for (const auto* column : {&part_digest, &variant_of, &style}) {
    if (*column) all.push_back(&**column);
  }
  add(outline.columns());
  add(field.columns());
  add(artwork.columns());
  add(original.columns());
  add(surroundings.columns());
  for (const LevelReader& level : levels) add(level.columns());
  return all;
}

/// Checks that every column has a row for each shape, but for columns that offsets lead to.
void LibraryFile::State::check_rows() const {
  if (head.shapes() == 0) throw Hdf5Error("the library is empty");
  if (head.shapes() > layout::kMaxShapes) throw Hdf5Error("too many shapes");
  for (const ColumnReader* column : columns()) {
    const std::string& name = column->column().path;
    if (is_one_of(name, {&format.first_point, &format.outline_points, &format.thumbnail_bytes, &format.original_bytes,
                         &format.surroundings_bytes}))
      continue;
    const bool offsets = is_one_of(name, {&format.first_curve, &format.first_thumbnail_byte,
                                          &format.first_original_byte, &format.first_surroundings_byte});
    if (column->rows() != head.shapes() + offsets) throw Hdf5Error("data set " + name + " has a wrong number of rows");
  }
}

/// Checks the declared sizes: data sets may claim any size without data, or with data that inflate a thousandfold.
void LibraryFile::State::check_declared_bytes() const {
  std::uint64_t declared = 0;
  for (const ColumnReader* column : columns()) declared += column->declared_bytes();
  const std::uint64_t file_bytes = std::filesystem::file_size(path);
  if (declared > layout::kMaxInflation * file_bytes) {
    throw Hdf5Error("damaged: it claims " + std::to_string(declared) + " bytes of data in a file of " +
                    std::to_string(file_bytes) + "; allowed are " + std::to_string(layout::kMaxInflation) +
                    " times its size");
  }
}

std::vector<PartDigests> LibraryFile::State::stored_digests(std::size_t begin, std::size_t end) const {
  return part_digest ? part_digest->read<PartDigests>(begin, end) : std::vector<PartDigests>();
}

std::vector<PartDigests> LibraryFile::State::read_batch(const ShapeBatch& range, const LibraryParts& parts) const {
  const std::vector<PartDigests> stored = stored_digests(range.begin, range.end);
  std::vector<PartDigests> found(range.count());
  const auto take = [&](std::size_t part, const std::vector<std::uint64_t>& digests) {
    for (std::size_t i = 0; i < range.count(); ++i) {
      found[i][part] = digests[i];
      if (!stored.empty() && stored[i][part] != digests[i])
        throw Hdf5Error("damaged: shape " + std::to_string(range.begin + i) + " is not the one that was written");
    }
  };
  head.read(range);
  if (parts.outline) take(0, outline.read(range));
  if (parts.field) take(1, field.read(range));
  for (std::size_t k = 0; k < levels.size(); ++k) {
    if (parts.levels >> k & 1u) take(2 + k, levels[k].read(range, pad.levels));
  }
  if (parts.artwork) artwork.read(range);
  if (parts.original) original.read(range, &Artwork::original);
  if (parts.surroundings) surroundings.read(range);
  return found;
}

/// The digests of the shapes [begin, end). Where the library stores none, they are computed from all parts, which gives the
/// same numbers.
std::vector<PartDigests> LibraryFile::State::digests(std::size_t begin, std::size_t end) const {
  if (part_digest) return stored_digests(begin, end);
  std::vector<Shape> shapes(end - begin);
  return read_batch({begin, end, shapes.data()},
                    {.outline = true, .field = true, .levels = ~0u, .artwork = false, .original = false});
}

/// Reads and checks variants: the first shape of a silhouette is its own variant, and comes before the others.
std::vector<std::uint32_t> LibraryFile::State::variants(std::size_t begin, std::size_t end) const {
  std::vector<std::uint32_t> variants(end - begin);
  std::iota(variants.begin(), variants.end(), std::uint32_t(begin));
  if (!variant_of) return variants;
  const std::vector<std::int32_t> stored = variant_of->read<std::int32_t>(begin, end);
  for (std::size_t i = 0; i < stored.size(); ++i) {
    if (stored[i] < 0 || std::size_t(stored[i]) > begin + i)
      throw Hdf5Error("data set " + format.variant_of.path + ": a value is out of range");
    variants[i] = std::uint32_t(stored[i]);
  }
  return variants;
}

std::vector<StyleFeatures> LibraryFile::State::styles(std::size_t begin, std::size_t end) const {
  if (!style) return std::vector<StyleFeatures>(end - begin);
  std::vector<StyleFeatures> styles = style->read<StyleFeatures>(begin, end);
  if (!std::all_of(styles.begin(), styles.end(), is_style))
    throw Hdf5Error("data set " + format.style.path + ": a value is out of range");
  return styles;
}

std::vector<ShapeHead> LibraryFile::State::heads(std::size_t begin, std::size_t end) const {
  std::vector<Shape> shapes(end - begin);
  head.read({begin, end, shapes.data()});
  const std::vector<PartDigests> digest = digests(begin, end);
  const std::vector<std::uint32_t> variant = variants(begin, end);
  const std::vector<StyleFeatures> styles = this->styles(begin, end);
  std::vector<ShapeHead> heads;
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    Shape& shape = shapes[i];
    heads.push_back({std::move(shape.name), shape.perimeter, shape.radius, shape.mean_lab, digest[i], variant[i],
                     shape.drawn_scale_px, styles[i]});
  }
  return heads;
}

LibraryFile::LibraryFile(const std::string& path)
    : state_(naming_the_file(path, [&] {
        // The summary looks up every chunk, so that all metadata are read.
        try_in_child([&] { State(path).summary(); });
        return std::make_unique<State>(path);
      })) {}

LibraryFile::~LibraryFile() = default;
LibraryFile::LibraryFile(LibraryFile&&) noexcept = default;
LibraryFile& LibraryFile::operator=(LibraryFile&&) noexcept = default;

const std::string& LibraryFile::path() const { return state_->path; }
std::size_t LibraryFile::size() const { return state_->head.shapes(); }
PadParameters LibraryFile::pad_parameters() const { return state_->pad; }

LibrarySummary LibraryFile::State::summary() const {
  LibrarySummary summary;
  summary.shapes = head.shapes();
  summary.curves = outline.curves();
  summary.outline_points = outline.points();
  summary.original_bytes = original.bytes();
  summary.file_bytes = std::filesystem::file_size(path);
  for (const ColumnReader* column : columns()) {
    const std::string& name = column->column().path;
    const std::string part = name.substr(1, name.rfind('/') - 1);
    auto& parts = summary.stored_bytes_of_part;
    if (parts.empty() || parts.back().first != part) parts.emplace_back(part, 0);
    parts.back().second += column->stored_bytes();
  }
  if (segments.bytes > 0) summary.stored_bytes_of_part.emplace_back("models", segments.bytes);
  return summary;
}

std::vector<Shape> LibraryFile::State::read(std::size_t begin, std::size_t end, const LibraryParts& parts) const {
  std::vector<Shape> shapes(end - begin);
  for (std::size_t at = begin; at < end; at += kBatchShapes) {
    read_batch({at, std::min(end, at + kBatchShapes), shapes.data() + (at - begin)}, parts);
  }
  return shapes;
}

LibrarySummary LibraryFile::summary() const {
  return naming_the_file(path(), [&] { return state_->summary(); });
}

std::uint64_t LibraryFile::content_digest() const {
  return digest_of_heads(pad_parameters(), size(),
                         [&](std::size_t begin, std::size_t end) { return heads(begin, end); });
}

std::vector<std::uint32_t> LibraryFile::variant_of() const {
  return naming_the_file(path(), [&] {
    const std::vector<std::uint32_t> variants = state_->variants(0, size());
    for (const std::uint32_t first : variants) {
      if (variants[first] != first) throw Hdf5Error("damaged: a variant of a shape that is a variant itself");
    }
    return variants;
  });
}

std::vector<StyleFeatures> LibraryFile::styles() const {
  return naming_the_file(path(), [&] { return state_->styles(0, size()); });
}

bool LibraryFile::has_surroundings() const { return state_->surroundings.bytes() > 0; }

std::vector<std::uint32_t> LibraryFile::drawings() const {
  std::vector<std::uint32_t> own(size());
  std::iota(own.begin(), own.end(), 0u);
  return own;
}

std::vector<ShapeHead> LibraryFile::heads(std::size_t begin, std::size_t end) const {
  return naming_the_file(path(), [&] { return state_->heads(begin, end); });
}

std::shared_ptr<const ModelSource> LibraryFile::stored_models(const MatchingContext& context) const {
  if (state_->segments.begins.empty() || context.pad != pad_parameters()) return nullptr;
  auto reader = std::make_shared<const SegmentReader>(path(), state_->bytes, library_segments(pad_parameters()),
                                                      std::uint32_t(size()), state_->segments.begins);
  const auto owners = [state = state_.get()](const ShapeRange& range) {
    return naming_the_file(state->path, [&] {
      std::vector<Shape> shapes(range.size());
      state->head.read({range.begin, range.end, shapes.data()});
      const std::vector<PartDigests> digests = state->digests(range.begin, range.end);
      std::vector<SegmentOwner> owners;
      for (std::size_t i = 0; i < shapes.size(); ++i) owners.push_back(segment_owner(shapes[i], digests[i]));
      return owners;
    });
  };
  return std::make_shared<StoredModels>(std::move(reader), context, owners);
}

std::vector<Shape> LibraryFile::read(std::size_t begin, std::size_t end, const LibraryParts& parts) const {
  end = std::min(end, size());
  if (begin >= end) return {};
  return naming_the_file(path(), [&] { return state_->read(begin, end, parts); });
}

}  // namespace tessera
