#include "library_surgery.h"

#include <zlib.h>

#include <stdexcept>

#include "support/library_columns.h"

namespace tessera::test {
namespace {

std::vector<std::uint8_t> shuffled(const std::vector<std::uint8_t>& bytes, std::size_t element) {
  std::vector<std::uint8_t> result(bytes.size());
  const std::size_t elements = bytes.size() / element;
  for (std::size_t i = 0; i < elements; ++i) {
    for (std::size_t b = 0; b < element; ++b) result[b * elements + i] = bytes[i * element + b];
  }
  return result;
}

std::vector<hsize_t> corner_at(const OpenColumn& open, std::size_t row) {
  std::vector<hsize_t> corner(open.dims.size(), 0);
  corner[0] = row;
  return corner;
}

}  // namespace

std::vector<Column> all_columns() { return all_columns(layout::library_columns(5)); }

void change_library(const std::string& path, const std::function<void(hid_t)>& change) {
  const Hdf5Silence silence;
  const hid_t access = H5Pcreate(H5P_FILE_ACCESS);
  H5Pset_libver_bounds(access, H5F_LIBVER_V110, H5F_LIBVER_V110);
  const hid_t file = H5Fopen(path.c_str(), H5F_ACC_RDWR, access);
  if (file < 0) throw std::runtime_error("cannot open " + path);
  change(file);
  H5Fclose(file);
  H5Pclose(access);
}

OpenColumn open_column(hid_t file, const Column& column) {
  OpenColumn open{H5Dopen2(file, column.path.c_str(), H5P_DEFAULT), {}, {}};
  const hid_t space = H5Dget_space(open.set);
  const hid_t properties = H5Dget_create_plist(open.set);
  open.dims.resize(std::size_t(H5Sget_simple_extent_ndims(space)));
  open.chunk.resize(open.dims.size());
  H5Sget_simple_extent_dims(space, open.dims.data(), nullptr);
  H5Pget_chunk(properties, int(open.chunk.size()), open.chunk.data());
  H5Pclose(properties);
  H5Sclose(space);
  return open;
}

ChunkPacking packing_of(const OpenColumn& open, const Column& column) {
  return {open.chunk_rows() * layout::row_bytes(column), layout::element_bytes(column), column.compressed};
}

std::vector<std::uint8_t> deflated(const std::vector<std::uint8_t>& bytes) {
  uLongf size = compressBound(uLong(bytes.size()));
  std::vector<std::uint8_t> packed(size);
  compress2(packed.data(), &size, bytes.data(), uLong(bytes.size()), 9);
  packed.resize(size);
  return packed;
}

std::vector<std::uint8_t> with_checksum(std::vector<std::uint8_t> bytes) {
  const std::uint32_t sum = fletcher32(bytes);
  for (int b = 0; b < 4; ++b) bytes.push_back(std::uint8_t(sum >> 8 * b));
  return bytes;
}

std::vector<std::uint8_t> packed(const std::vector<std::uint8_t>& content, const ChunkPacking& packing) {
  return with_checksum(packing.deflated ? deflated(shuffled(content, packing.element_bytes)) : content);
}

std::vector<std::uint8_t> read_chunk_at(const OpenColumn& open, std::size_t row, const ChunkPacking& packing) {
  return read_chunk(open.set, corner_at(open, row), packing, "good");
}

void store_chunk_at(const OpenColumn& open, std::size_t row, const std::vector<std::uint8_t>& bytes,
                    std::uint32_t skipped_filters) {
  H5Dwrite_chunk(open.set, H5P_DEFAULT, skipped_filters, corner_at(open, row).data(), bytes.size(), bytes.data());
}

void declare_anew(hid_t file, const Column& column, hid_t type, hid_t space, hid_t properties) {
  H5Ldelete(file, column.path.c_str(), H5P_DEFAULT);
  const hid_t made = H5Dcreate2(file, column.path.c_str(), type, space, H5P_DEFAULT, properties, H5P_DEFAULT);
  if (made >= 0) H5Dclose(made);
}

}  // namespace tessera::test
