#include "checkpoint/checkpoint_seal.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/digest.h"
#include "core/base/error.h"
#include "files/regular_file.h"
#include "text/digest_text.h"

namespace tessera {
namespace {

constexpr std::string_view kMagic = "tessera-checkpoint\n";
constexpr std::size_t kBlockBytes = std::size_t(1) << 20;

using Seal = std::array<char, kSealBytes>;

Seal make_seal(std::uint64_t bytes, std::uint64_t digest) {
  const std::string text = std::string(kMagic) + "version " + std::to_string(kCheckpointVersion) + "\nbytes " +
                           std::to_string(bytes) + "\ndigest " + digest_text(digest) + "\n";
  Seal seal{};
  std::copy_n(text.begin(), std::min(text.size(), seal.size()), seal.begin());
  return seal;
}

/// Adds the bytes block by block, in the same blocks in which a file is read.
void add_blocks(Digest& digest, std::span<const std::uint8_t> bytes) {
  for (; !bytes.empty(); bytes = bytes.subspan(std::min(kBlockBytes, bytes.size()))) {
    digest.add_all(bytes.first(std::min(kBlockBytes, bytes.size())));
  }
}

/// The digest of everything behind the seal.
std::uint64_t digest_of_rest(const std::string& path, const FileDescriptor& file) {
  Digest digest;
  std::vector<std::uint8_t> block(kBlockBytes);
  for (std::size_t at = kSealBytes; const std::size_t got = read_at(path, file, at, block); at += got)
    add_blocks(digest, std::span(block).first(got));
  return digest.value();
}

/// The number after "name " at the start of a line; 0 where there is none.
std::uint64_t number_after(std::string_view seal, const std::string& name) {
  const std::size_t at = seal.find("\n" + name + " ");
  std::uint64_t value = 0;
  if (at == std::string_view::npos) return 0;
  for (std::size_t i = at + name.size() + 2; i < seal.size() && seal[i] >= '0' && seal[i] <= '9'; ++i) {
    value = 10 * value + std::uint64_t(seal[i] - '0');
  }
  return value;
}

void check_version(const std::string& path, std::uint64_t version) {
  if (version == std::uint64_t(kCheckpointVersion)) return;
  throw InputError(path + ": checkpoint format version " + std::to_string(version) + ", this program reads version " +
                   std::to_string(kCheckpointVersion) + "; continue with the program that wrote it");
}

}  // namespace

void seal_checkpoint(std::span<std::uint8_t> file) {
  Digest digest;
  add_blocks(digest, file.subspan(kSealBytes));
  const Seal seal = make_seal(file.size(), digest.value());
  std::copy(seal.begin(), seal.end(), file.begin());
}

void check_seal(const std::string& path) {
  std::error_code error;
  if (!std::filesystem::exists(path, error)) throw InputError(path + ": no such file");
  const FileDescriptor file = open_regular_file(path);
  const std::uint64_t size = size_of(path, file);
  Seal seal{};
  const std::size_t got = read_at(path, file, 0, {reinterpret_cast<std::uint8_t*>(seal.data()), seal.size()});
  const std::string_view text(seal.data(), got);
  if (text.substr(0, kMagic.size()) != kMagic.substr(0, text.size())) throw InputError(path + ": not a checkpoint");
  if (text.size() < kSealBytes) throw InputError(path + ": cut off after " + std::to_string(text.size()) + " bytes");
  check_version(path, number_after(text, "version"));
  const std::uint64_t bytes = number_after(text, "bytes");
  if (size < bytes) {
    throw InputError(path + ": cut off: " + std::to_string(size) + " of " + std::to_string(bytes) + " bytes");
  }
  if (size != bytes || size > kMaxCheckpointBytes || seal != make_seal(size, digest_of_rest(path, file))) {
    throw InputError(path + ": damaged: its bytes are not those that were written");
  }
}

}  // namespace tessera
