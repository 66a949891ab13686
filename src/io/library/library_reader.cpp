#include <algorithm>
#include <filesystem>

#include "core/base/digest.h"
#include "core/base/error.h"
#include "io/library/library_file.h"
#include "io/library/library_open.h"
#include "io/library/library_parts.h"

namespace tessera::io {
namespace {

constexpr std::size_t kDigestRows = 65536;   // read at a time
constexpr std::size_t kBatchShapes = 256;  // bounds what is held twice while reading

bool is_one_of(const std::string& path, std::initializer_list<const layout::Column*> columns) {
  return std::any_of(columns.begin(), columns.end(), [&](const layout::Column* c) { return c->path == path; });
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
        artwork(file.get(), format),
        original(file.get(), format.first_original_byte, format.original_bytes, layout::kMaxOriginalBytes) {
    for (std::size_t k = 0; k < format.levels.size(); ++k) levels.emplace_back(file.get(), format.levels[k], k);
    check_rows();
    check_stored_bytes();
  }

  std::vector<const ColumnReader*> columns() const;
  void check_rows() const;
  void check_stored_bytes() const;
  void read_batch(const ShapeRange& range, const LibraryParts& parts) const;

  std::string path;
  Hdf5Handle file;
  PadParameters pad;
  layout::Columns format;
  HeadReader head;
  OutlineReader outline;
  FieldReader field;
  ArtworkReader artwork;
  BytesReader original;
  std::vector<LevelReader> levels;
};

std::vector<const ColumnReader*> LibraryFile::State::columns() const {
  std::vector<const ColumnReader*> all;
  const auto add = [&](const std::vector<const ColumnReader*>& some) {
    all.insert(all.end(), some.begin(), some.end());
  };
  add(head.columns());
  add(outline.columns());
  add(field.columns());
  add(artwork.columns());
  add(original.columns());
  for (const LevelReader& level : levels) add(level.columns());
  return all;
}

/// Every column has a row for each shape, but for those that hold what offsets lead to.
void LibraryFile::State::check_rows() const {
  if (head.shapes() == 0) throw Hdf5Error("the library is empty");
  if (head.shapes() > layout::kMaxShapes) throw Hdf5Error("too many shapes");
  for (const ColumnReader* column : columns()) {
    const std::string& name = column->column().path;
    if (is_one_of(name, {&format.first_point, &format.outline_points, &format.thumbnail_bytes, &format.original_bytes}))
      continue;
    const bool offsets =
        is_one_of(name, {&format.first_curve, &format.first_thumbnail_byte, &format.first_original_byte});
    if (column->rows() != head.shapes() + offsets) throw Hdf5Error("data set " + name + " has a wrong number of rows");
  }
}

/// Chunks that share bytes of the file would let a small file fill any memory.
void LibraryFile::State::check_stored_bytes() const {
  std::uint64_t stored = 0;
  for (const ColumnReader* column : columns()) stored += column->stored_bytes();
  if (stored > std::filesystem::file_size(path)) throw Hdf5Error("damaged: it claims more bytes than it has");
}

void LibraryFile::State::read_batch(const ShapeRange& range, const LibraryParts& parts) const {
  head.read(range);
  if (parts.outline) outline.read(range);
  if (parts.field) field.read(range);
  if (parts.artwork) artwork.read(range);
  if (parts.original) original.read(range, &Artwork::original);
  for (std::size_t k = 0; k < levels.size(); ++k) {
    if (parts.levels >> k & 1u) levels[k].read(range, pad.levels);
  }
}

LibraryFile::LibraryFile(const std::string& path) {
  const Hdf5Silence silence;
  try {
    state_ = std::make_unique<State>(path);
  } catch (const Hdf5Error& error) {
    throw InputError(path + ": " + error.what());
  }
}

LibraryFile::~LibraryFile() = default;
LibraryFile::LibraryFile(LibraryFile&&) noexcept = default;
LibraryFile& LibraryFile::operator=(LibraryFile&&) noexcept = default;

const std::string& LibraryFile::path() const { return state_->path; }
std::size_t LibraryFile::size() const { return state_->head.shapes(); }
PadParameters LibraryFile::pad_parameters() const { return state_->pad; }

LibrarySummary LibraryFile::summary() const {
  const Hdf5Silence silence;
  LibrarySummary summary;
  summary.shapes = size();
  summary.curves = state_->outline.curves();
  summary.outline_points = state_->outline.points();
  summary.original_bytes = state_->original.bytes();
  summary.file_bytes = std::filesystem::file_size(path());
  for (const ColumnReader* column : state_->columns()) {
    const std::string& name = column->column().path;
    const std::string part = name.substr(1, name.rfind('/') - 1);
    auto& parts = summary.stored_bytes_of_part;
    if (parts.empty() || parts.back().first != part) parts.emplace_back(part, 0);
    parts.back().second += column->stored_bytes();
  }
  return summary;
}

std::uint64_t LibraryFile::content_digest() const {
  const Hdf5Silence silence;
  Digest digest;
  try {
    for (const ColumnReader* column : state_->columns()) {
      if (column->column().path.starts_with("/artwork")) continue;
      digest.add_all(std::span<const char>(column->column().path));
      digest.add(column->rows());
      digest.add(column->stored_bytes());
      if (column->rows() != size() || layout::row_bytes(column->column()) > layout::kNameBytes) continue;
      for (std::size_t at = 0; at < size(); at += kDigestRows) {
        digest.add_all(std::span<const char>(column->read<char>(at, std::min(size(), at + kDigestRows))));
      }
    }
  } catch (const Hdf5Error& error) {
    throw InputError(path() + ": " + error.what());
  }
  return digest.value();
}

std::vector<Shape> LibraryFile::read(std::size_t begin, std::size_t end, const LibraryParts& parts) const {
  const Hdf5Silence silence;
  end = std::min(end, size());
  if (begin >= end) return {};
  std::vector<Shape> shapes(end - begin);
  try {
    for (std::size_t at = begin; at < end; at += kBatchShapes) {
      state_->read_batch({at, std::min(end, at + kBatchShapes), shapes.data() + (at - begin)}, parts);
    }
  } catch (const Hdf5Error& error) {
    throw InputError(path() + ": " + error.what());
  }
  return shapes;
}

}  // namespace tessera::io
