// How the values of messages become bytes and back: the one format in which ranks talk. The bytes travel only between
// ranks of one job, on machines of one kind: they have no version and no byte order. Bytes that were cut off, or that
// another program sent, are an error before memory is taken for what they claim to hold.
//
// A type travels as it lies in memory where kSentAsItLies says so. Any other type travels by its members: whoever sends
// it defines, in the type's namespace or in this one,
//   template <class Archive> void serialize(Archive& archive, Type& value)
// which names all members in a structured binding, so that a forgotten one does not compile, and calls
// archive(member, member...). The same function serves MessageWriter and MessageReader (Archive::kReads).
#pragma once

#include <array>
#include <concepts>
#include <cstdint>
#include <cstring>
#include <string>
#include <type_traits>
#include <vector>

#include "comm/message.h"
#include "core/geometry/grid.h"

namespace tessera::comm {

/// Whether values of this type travel as they lie in memory: of them a vector costs one copy. To be specialised for
/// types without pointers, several at once by kIsOneOf.
template <class T>
inline constexpr bool kSentAsItLies = std::is_arithmetic_v<T> || std::is_enum_v<T>;
template <class T, std::size_t kSize>
inline constexpr bool kSentAsItLies<std::array<T, kSize>> = kSentAsItLies<T>;

template <class T, class... Types>
inline constexpr bool kIsOneOf = (std::same_as<T, Types> || ...);

template <class T>
concept SentAsItLies = kSentAsItLies<T> && std::is_trivially_copyable_v<T>;

/// Throws the EnvironmentError of a message that this program does not understand.
[[noreturn]] void refuse_message(std::size_t message_bytes);

/// Appends values to bytes, or only counts their bytes.
class MessageWriter {
 public:
  static constexpr bool kReads = false;

  /// Counts where `bytes` is null.
  explicit MessageWriter(Bytes* bytes) : bytes_(bytes) {}

  template <class... T>
  void operator()(const T&... values) {
    (write(values), ...);
  }
  std::size_t count() const { return count_; }

 private:
  void write_bytes(const void* data, std::size_t bytes) {
    count_ += bytes;
    const char* const begin = static_cast<const char*>(data);
    if (bytes_ && bytes > 0) bytes_->insert(bytes_->end(), begin, begin + bytes);
  }

  template <SentAsItLies T>
  void write(const T& value) {
    write_bytes(&value, sizeof value);
  }
  template <class T>
  void write(const std::vector<T>& values) {
    write(std::uint64_t(values.size()));
    if constexpr (SentAsItLies<T>) {
      write_bytes(values.data(), values.size() * sizeof(T));
    } else {
      for (const T& value : values) write(value);
    }
  }
  void write(const std::string& text) {
    write(std::uint64_t(text.size()));
    write_bytes(text.data(), text.size());
  }
  template <class T>
  requires(!SentAsItLies<T>) void write(const T& value) {
    serialize(*this, const_cast<T&>(value));  // a reader's serialize changes its value, a writer's does not
  }

  Bytes* bytes_;
  std::size_t count_ = 0;
};

/// Takes values out of bytes, which outlive it. Throws EnvironmentError where they do not hold what is asked for.
class MessageReader {
 public:
  static constexpr bool kReads = true;

  explicit MessageReader(const Bytes& bytes) : bytes_(bytes) {}

  template <class... T>
  void operator()(T&... values) {
    (read(values), ...);
  }
  /// To be asked before memory is taken for `count` values of T that are still to be read.
  template <class T>
  void expect(std::uint64_t count) const {
    if (count > (bytes_.size() - at_) / sizeof(T)) refuse();
  }
  void expect_end() const {
    if (at_ != bytes_.size()) refuse();
  }
  [[noreturn]] void refuse() const { refuse_message(bytes_.size()); }

 private:
  void read_bytes(void* data, std::size_t bytes) {
    if (bytes > 0) std::memcpy(data, bytes_.data() + at_, bytes);
    at_ += bytes;
  }
  template <class T>
  std::size_t read_count() {
    std::uint64_t count = 0;
    read(count);
    expect<T>(count);
    return std::size_t(count);
  }

  template <SentAsItLies T>
  void read(T& value) {
    expect<T>(1);
    if constexpr (std::same_as<T, bool>) {
      if (static_cast<unsigned char>(bytes_[at_]) > 1) refuse();
    }
    read_bytes(&value, sizeof value);
  }
  template <class T>
  void read(std::vector<T>& values) {
    if constexpr (SentAsItLies<T>) {
      values.resize(read_count<T>());
      read_bytes(values.data(), values.size() * sizeof(T));
    } else {  // a value takes a byte or more, so that memory grows no faster than the message is read
      values.clear();
      for (std::size_t left = read_count<char>(); left > 0; --left) read(values.emplace_back());
    }
  }
  void read(std::string& text) {
    text.resize(read_count<char>());
    read_bytes(text.data(), text.size());
  }
  template <class T>
  requires(!SentAsItLies<T>) void read(T& value) { serialize(*this, value); }

  const Bytes& bytes_;
  std::size_t at_ = 0;
};

template <class Archive, SentAsItLies T>
void serialize(Archive& archive, Grid<T>& grid) {
  int width = grid.width();
  int height = grid.height();
  archive(width, height);
  if constexpr (Archive::kReads) {
    if (width < 0 || height < 0) archive.refuse();
    archive.template expect<T>(std::uint64_t(width) * std::uint64_t(height));
    grid = Grid<T>(width, height);
  }
  archive(grid.data());
  if constexpr (Archive::kReads) {
    if (grid.data().size() != std::size_t(width) * std::size_t(height)) archive.refuse();
  }
}

}  // namespace tessera::comm
