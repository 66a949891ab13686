#include "library/storage/library_column.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <string>

#include "library/hdf5/hdf5_attributes.h"

namespace tessera {
namespace {

using layout::Column;

// Small enough that little is wasted at the ends of a rank's range, large enough to compress and to be worth a disk access.
constexpr std::size_t kChunkBytes = 32 << 10;    // a field: the master reads shapes one at a time
constexpr std::size_t kMaxChunkBytes = 1 << 20;  // the largest that a reader accepts
/// Unpacked chunks that a column keeps. Of columns with a number for each shape these are 250,000 shapes. With one chunk a
/// master of 20,000 shapes spent a quarter of its time on unpacking.
constexpr std::size_t kKeptBytes = 1 << 20;
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

Hdf5Handle open_data_set(hid_t file, const Column& column) {
  check_hard_links(file, column.path, name_of(column));
  return {H5Dopen2(file, column.path.c_str(), H5P_DEFAULT), name_of(column)};
}

/// Checks that the data set is chunked, because chunked storage is always inside the file. To be called before anything
/// else: for a virtual data set HDF5 finds the extent by opening other files.
Hdf5Handle chunked_properties(hid_t data_set, const std::string& what) {
  Hdf5Handle properties(H5Dget_create_plist(data_set), what);
  if (H5Pget_layout(properties.get()) != H5D_CHUNKED) throw Hdf5Error(what + " is not chunked");
  return properties;
}

void check_type(hid_t data_set, const Column& column) {
  const Hdf5Handle type(H5Dget_type(data_set), name_of(column));
  if (H5Tcommitted(type.get()) != 0 || H5Tequal(type.get(), file_type(column).get()) <= 0)
    throw Hdf5Error(name_of(column) + " is of a wrong type");
}

/// Checks the dimensions and returns the number of rows.
std::size_t check_dims(hid_t data_set, const Column& column) {
  const std::string what = name_of(column);
  const Hdf5Handle space(H5Dget_space(data_set), what);
  std::array<hsize_t, H5S_MAX_RANK> dims{};
  const int rank = hdf5_checked(H5Sget_simple_extent_dims(space.get(), dims.data(), nullptr), what);
  if (rank != int(1 + column.row_dims.size()) ||
      !std::equal(column.row_dims.begin(), column.row_dims.end(), dims.begin() + 1)) {
    throw Hdf5Error(what + " has wrong dimensions");
  }
  if (dims[0] > layout::kMaxRows) throw Hdf5Error(what + " has too many rows");
  return dims[0];
}

struct Filter {
  H5Z_filter_t kind;
  unsigned value;  // the first of its parameters
  friend bool operator==(const Filter&, const Filter&) = default;
};

std::vector<Filter> filters_of(hid_t properties, const std::string& what) {
  std::vector<Filter> filters(std::size_t(hdf5_checked(H5Pget_nfilters(properties), what)));
  for (unsigned i = 0; i < filters.size(); ++i) {
    unsigned flags = 0;
    unsigned config = 0;
    std::size_t values = 1;
    filters[i].kind = H5Pget_filter2(properties, i, &flags, &values, &filters[i].value, 0, nullptr, &config);
    if (values == 0) filters[i].value = 0;
  }
  return filters;
}

/// Checks that the filters are ours, in the order in which they pack, and returns whether one deflates. Older versions
/// deflated every column. All levels of deflating inflate alike.
bool is_deflated(hid_t properties, const Column& column) {
  std::vector<Filter> filters = filters_of(properties, name_of(column));
  for (Filter& filter : filters) {
    if (filter.kind == H5Z_FILTER_DEFLATE) filter.value = kDeflateLevel;
  }
  const Filter shuffle{H5Z_FILTER_SHUFFLE, unsigned(layout::element_bytes(column))};
  const Filter deflate{H5Z_FILTER_DEFLATE, kDeflateLevel};
  const Filter checksum{H5Z_FILTER_FLETCHER32, 0};
  if (filters == std::vector<Filter>{checksum}) return false;
  if (filters == std::vector<Filter>{shuffle, deflate, checksum}) return true;
  throw Hdf5Error(name_of(column) + " is packed by other filters than this program's");
}

/// Checks the chunks, which hold whole rows, and returns the number of rows in a chunk.
std::size_t check_chunk(hid_t properties, const Column& column) {
  std::array<hsize_t, H5S_MAX_RANK> chunk{};
  hdf5_checked(H5Pget_chunk(properties, H5S_MAX_RANK, chunk.data()), name_of(column));
  if (!std::equal(column.row_dims.begin(), column.row_dims.end(), chunk.begin() + 1) || chunk[0] == 0 ||
      chunk[0] > kMaxChunkBytes / layout::row_bytes(column)) {
    throw Hdf5Error(name_of(column) + " has wrong chunks");
  }
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

ColumnReader::ColumnReader(hid_t file, const Column& column) : column_(column), data_set_(open_data_set(file, column)) {
  const Hdf5Handle properties = chunked_properties(data_set_.get(), name_of(column));
  check_type(data_set_.get(), column);
  rows_ = check_dims(data_set_.get(), column);
  chunk_rows_ = check_chunk(properties.get(), column);
  packing_ = {.bytes = chunk_rows_ * layout::row_bytes(column),
              .element_bytes = layout::element_bytes(column),
              .deflated = is_deflated(properties.get(), column)};
}

std::optional<ColumnReader> ColumnReader::if_present(hid_t file, const Column& column) {
  if (H5Lexists(file, column.path.c_str(), H5P_DEFAULT) <= 0) return {};
  return ColumnReader(file, column);
}

std::uint64_t ColumnReader::stored_bytes() const {
  std::uint64_t bytes = 0;
  for (std::size_t row = 0; row < rows_; row += chunk_rows_)
    bytes += stored_chunk_bytes(data_set_.get(), corner(row), name_of(column_));
  return bytes;
}

std::uint64_t ColumnReader::declared_bytes() const { return std::uint64_t(rows_) * layout::row_bytes(column_); }

void ColumnReader::read_into(void* data, std::size_t begin, std::size_t end) const {
  const std::size_t row_bytes = layout::row_bytes(column_);
  auto* to = static_cast<std::uint8_t*>(data);
  while (begin < end) {
    const std::size_t first = begin - begin % chunk_rows_;
    const std::size_t rows = std::min(end, first + chunk_rows_) - begin;
    std::memcpy(to, chunk(first).data() + (begin - first) * row_bytes, rows * row_bytes);
    to += rows * row_bytes;
    begin += rows;
  }
}

std::vector<hsize_t> ColumnReader::corner(std::size_t first_row) const {
  std::vector<hsize_t> corner(1 + column_.row_dims.size(), 0);
  corner[0] = first_row;
  return corner;
}

const std::vector<std::uint8_t>& ColumnReader::chunk(std::size_t first_row) const {
  const auto known = std::find_if(kept_.begin(), kept_.end(), [&](const Kept& k) { return k.first_row == first_row; });
  if (known != kept_.end()) {
    kept_.splice(kept_.begin(), kept_, known);
  } else {
    std::vector<std::uint8_t> bytes = read_chunk(data_set_.get(), corner(first_row), packing_, name_of(column_));
    if ((kept_.size() + 1) * packing_.bytes > kKeptBytes && !kept_.empty()) kept_.pop_back();
    kept_.push_front({first_row, std::move(bytes)});
  }
  return kept_.front().bytes;
}

}  // namespace tessera
