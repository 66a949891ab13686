#include "io/library/library_column.h"

#include <algorithm>
#include <array>
#include <string>

#include "io/library/hdf5_attributes.h"

namespace tessera::io {
namespace {

using layout::Column;

// Small enough that a rank's range wastes little at its ends, large enough to compress and to be worth a disk access.
constexpr std::size_t kChunkBytes = 32 << 10;  // a field: the master reads shapes one at a time
constexpr std::size_t kMaxChunkBytes = 16 << 20;  // that a reader accepts
constexpr unsigned kDeflateLevel = 4;

std::string name_of(const Column& column) { return "data set " + column.path; }

Hdf5Handle text_type(std::size_t bytes) {
  Hdf5Handle type(H5Tcopy(H5T_C_S1), "text type");
  hdf5_checked(H5Tset_size(type.get(), bytes), "text type");
  hdf5_checked(H5Tset_strpad(type.get(), H5T_STR_NULLTERM), "text type");
  hdf5_checked(H5Tset_cset(type.get(), H5T_CSET_UTF8), "text type");
  return type;
}

Hdf5Handle file_type(const Column& column) {
  switch (column.element) {
    case layout::Element::float32: return {H5Tcopy(H5T_IEEE_F32LE), "type"};
    case layout::Element::int16: return {H5Tcopy(H5T_STD_I16LE), "type"};
    case layout::Element::int32: return {H5Tcopy(H5T_STD_I32LE), "type"};
    case layout::Element::uint8: return {H5Tcopy(H5T_STD_U8LE), "type"};
    case layout::Element::int64: return {H5Tcopy(H5T_STD_I64LE), "type"};
    case layout::Element::uint64: return {H5Tcopy(H5T_STD_U64LE), "type"};
    case layout::Element::text: return text_type(column.text_bytes);
  }
  throw Hdf5Error(name_of(column) + ": unknown element type");
}

Hdf5Handle memory_type(const Column& column) {
  if (column.element == layout::Element::text) return text_type(column.text_bytes);
  return {H5Tget_native_type(file_type(column).get(), H5T_DIR_ASCEND), "type"};
}

std::vector<hsize_t> dims_of(const Column& column, hsize_t rows) {
  std::vector<hsize_t> dims{rows};
  dims.insert(dims.end(), column.row_dims.begin(), column.row_dims.end());
  return dims;
}

Hdf5Handle rows_space(const Column& column, hsize_t rows) {
  const std::vector<hsize_t> dims = dims_of(column, rows);
  return {H5Screate_simple(int(dims.size()), dims.data(), nullptr), name_of(column)};
}

/// The file's dataspace with rows [begin, end) selected.
Hdf5Handle selected_rows(const Column& column, hid_t data_set, hsize_t begin, hsize_t end) {
  Hdf5Handle space(H5Dget_space(data_set), name_of(column));
  std::vector<hsize_t> start(1 + column.row_dims.size(), 0);
  start[0] = begin;
  const std::vector<hsize_t> count = dims_of(column, end - begin);
  hdf5_checked(H5Sselect_hyperslab(space.get(), H5S_SELECT_SET, start.data(), nullptr, count.data(), nullptr),
               name_of(column));
  return space;
}

Hdf5Handle creation_properties(const Column& column) {
  const std::string what = name_of(column);
  Hdf5Handle properties(H5Pcreate(H5P_DATASET_CREATE), what);
  const auto chunk = dims_of(column, std::max<std::size_t>(1, kChunkBytes / layout::row_bytes(column)));
  hdf5_checked(H5Pset_chunk(properties.get(), int(chunk.size()), chunk.data()), what);
  if (column.compressed) {
    hdf5_checked(H5Pset_shuffle(properties.get()), what);
    hdf5_checked(H5Pset_deflate(properties.get(), kDeflateLevel), what);
  }
  hdf5_checked(H5Pset_fletcher32(properties.get()), what);
  hdf5_checked(H5Pset_obj_track_times(properties.get(), false), what);  // the same input gives the same bytes
  return properties;
}

Hdf5Handle create_data_set(hid_t file, const Column& column) {
  const std::string what = name_of(column);
  auto largest = dims_of(column, H5S_UNLIMITED);
  const auto dims = dims_of(column, 0);
  const Hdf5Handle space(H5Screate_simple(int(dims.size()), dims.data(), largest.data()), what);
  const Hdf5Handle properties = creation_properties(column);
  return {H5Dcreate2(file, column.path.c_str(), file_type(column).get(), space.get(), H5P_DEFAULT, properties.get(),
                     H5P_DEFAULT),
          what};
}

/// Every link on the way must be a hard one: soft and external links could lead to other files.
void check_links(hid_t file, const Column& column) {
  for (std::size_t slash = column.path.find('/', 1);; slash = column.path.find('/', slash + 1)) {
    const std::string prefix = column.path.substr(0, slash);
    H5L_info_t info{};
    if (H5Lexists(file, prefix.c_str(), H5P_DEFAULT) <= 0) throw Hdf5Error(name_of(column) + " is missing");
    hdf5_checked(H5Lget_info(file, prefix.c_str(), &info, H5P_DEFAULT), name_of(column));
    if (info.type != H5L_TYPE_HARD) throw Hdf5Error(name_of(column) + " is only a link");
    if (slash == std::string::npos) return;
  }
}

Hdf5Handle open_data_set(hid_t file, const Column& column) {
  check_links(file, column);
  return {H5Dopen2(file, column.path.c_str(), H5P_DEFAULT), name_of(column)};
}

/// Returns the rows.
std::size_t check_type_and_dims(hid_t data_set, const Column& column) {
  const std::string what = name_of(column);
  const Hdf5Handle type(H5Dget_type(data_set), what);
  if (H5Tequal(type.get(), file_type(column).get()) <= 0) throw Hdf5Error(what + " is of a wrong type");
  const Hdf5Handle space(H5Dget_space(data_set), what);
  std::array<hsize_t, H5S_MAX_RANK> dims{};
  const int rank = hdf5_checked(H5Sget_simple_extent_dims(space.get(), dims.data(), nullptr), what);
  if (rank != int(1 + column.row_dims.size()) ||
      !std::equal(column.row_dims.begin(), column.row_dims.end(), dims.begin() + 1)) {
    throw Hdf5Error(what + " has wrong dimensions");
  }
  return dims[0];
}

/// A filter that is not built in would make HDF5 load a plugin.
void check_filters(hid_t properties, const Column& column) {
  const int filters = hdf5_checked(H5Pget_nfilters(properties), name_of(column));
  for (int i = 0; i < filters; ++i) {
    unsigned flags = 0;
    std::size_t no_values = 0;
    unsigned config = 0;
    const H5Z_filter_t filter =
        H5Pget_filter2(properties, unsigned(i), &flags, &no_values, nullptr, 0, nullptr, &config);
    if (filter != H5Z_FILTER_SHUFFLE && filter != H5Z_FILTER_DEFLATE && filter != H5Z_FILTER_FLETCHER32) {
      throw Hdf5Error(name_of(column) + " uses the unknown filter " + std::to_string(filter));
    }
  }
}

/// Returns the rows of a chunk. Chunked storage is always inside the file; chunks span whole rows.
std::size_t check_storage(hid_t data_set, const Column& column, std::size_t rows) {
  const std::string what = name_of(column);
  const Hdf5Handle properties(H5Dget_create_plist(data_set), what);
  if (H5Pget_layout(properties.get()) != H5D_CHUNKED) throw Hdf5Error(what + " is not chunked");
  check_filters(properties.get(), column);
  std::array<hsize_t, H5S_MAX_RANK> chunk{};
  hdf5_checked(H5Pget_chunk(properties.get(), H5S_MAX_RANK, chunk.data()), what);
  if (!std::equal(column.row_dims.begin(), column.row_dims.end(), chunk.begin() + 1) || chunk[0] == 0 ||
      chunk[0] > kMaxChunkBytes / layout::row_bytes(column)) {
    throw Hdf5Error(what + " has wrong chunks");
  }
  // A data set may claim any size without a byte behind it.
  hsize_t chunks = 0;
  const Hdf5Handle space(H5Dget_space(data_set), what);
  hdf5_checked(H5Dget_num_chunks(data_set, space.get(), &chunks), what);
  if (chunks != rows / chunk[0] + (rows % chunk[0] != 0)) throw Hdf5Error(what + " lacks chunks");
  return chunk[0];
}

}  // namespace

ColumnWriter::ColumnWriter(hid_t file, const Column& column)
    : column_(column),
      data_set_(create_data_set(file, column)) {
  write_attribute(data_set_.get(), layout::kUnitsAttribute, column.units);
  write_attribute(data_set_.get(), layout::kDescriptionAttribute, column.description);
}

void ColumnWriter::append(const void* data, std::size_t rows) {
  if (rows == 0) return;
  // The data set's chunk cache collects the rows until a chunk is full.
  const auto dims = dims_of(column_, rows_ + rows);
  hdf5_checked(H5Dset_extent(data_set_.get(), dims.data()), name_of(column_));
  const Hdf5Handle from = rows_space(column_, rows);
  const Hdf5Handle to = selected_rows(column_, data_set_.get(), rows_, rows_ + rows);
  const Hdf5Handle type = memory_type(column_);
  hdf5_checked(H5Dwrite(data_set_.get(), type.get(), from.get(), to.get(), H5P_DEFAULT, data), name_of(column_));
  rows_ += rows;
}

ColumnReader::ColumnReader(hid_t file, const Column& column)
    : column_(column),
      data_set_(open_data_set(file, column)),
      rows_(check_type_and_dims(data_set_.get(), column)),
      chunk_rows_(check_storage(data_set_.get(), column, rows_)) {}

std::optional<ColumnReader> ColumnReader::if_present(hid_t file, const Column& column) {
  if (H5Lexists(file, column.path.c_str(), H5P_DEFAULT) <= 0) return {};
  return ColumnReader(file, column);
}

std::uint64_t ColumnReader::stored_bytes() const { return H5Dget_storage_size(data_set_.get()); }

void ColumnReader::read_into(void* data, std::size_t begin, std::size_t end) const {
  if (begin >= end) return;
  check_chunks_of(begin, end);
  const Hdf5Handle from = selected_rows(column_, data_set_.get(), begin, end);
  const Hdf5Handle to = rows_space(column_, end - begin);
  const Hdf5Handle type = memory_type(column_);
  hdf5_checked(H5Dread(data_set_.get(), type.get(), to.get(), from.get(), H5P_DEFAULT, data),
               name_of(column_) + " is damaged");
}

/// HDF5 inflates a chunk into as much memory as the stored bytes ask for; honest ones are hardly larger than the chunk.
void ColumnReader::check_chunks_of(std::size_t begin, std::size_t end) const {
  const std::size_t most = 2 * chunk_rows_ * layout::row_bytes(column_) + 1024;
  std::vector<hsize_t> corner(1 + column_.row_dims.size(), 0);
  for (std::size_t chunk = begin / chunk_rows_; chunk * chunk_rows_ < end; ++chunk) {
    corner[0] = chunk * chunk_rows_;
    hsize_t bytes = 0;
    hdf5_checked(H5Dget_chunk_storage_size(data_set_.get(), corner.data(), &bytes), name_of(column_));
    if (bytes > most) throw Hdf5Error(name_of(column_) + " is damaged: a chunk is too large");
  }
}

}  // namespace tessera::io
