#include "files/gunzip.h"

#include <gio/gio.h>

#include <memory>

#include "core/base/error.h"
#include "core/base/too_many.h"

namespace tessera {
namespace {

struct Unref {
  void operator()(void* object) const { g_object_unref(object); }
};
using StreamPtr = std::unique_ptr<GInputStream, Unref>;

StreamPtr plain_stream(std::span<const std::uint8_t> bytes) {
  const StreamPtr packed(g_memory_input_stream_new_from_data(bytes.data(), gssize(bytes.size()), nullptr));
  const std::unique_ptr<GZlibDecompressor, Unref> unzip(g_zlib_decompressor_new(G_ZLIB_COMPRESSOR_FORMAT_GZIP));
  return StreamPtr(g_converter_input_stream_new(packed.get(), G_CONVERTER(unzip.get())));
}

}  // namespace

bool is_gzip(std::span<const std::uint8_t> bytes) { return bytes.size() >= 2 && bytes[0] == 0x1f && bytes[1] == 0x8b; }

std::vector<std::uint8_t> gunzip(std::span<const std::uint8_t> bytes, const std::string& path,
                                 std::size_t limit_bytes) {
  const StreamPtr stream = plain_stream(bytes);
  std::vector<std::uint8_t> result;
  std::vector<std::uint8_t> block(1 << 16);
  while (true) {
    const gssize got = g_input_stream_read(stream.get(), block.data(), block.size(), nullptr, nullptr);
    if (got < 0) throw InputError(path + ": damaged gzip data");
    if (got == 0) return result;
    result.insert(result.end(), block.begin(), block.begin() + got);
    if (result.size() > limit_bytes) {
      throw InputError(path + ": " + too_many(limit_bytes >> 20, "MiB when decompressed"));
    }
  }
}

}  // namespace tessera
