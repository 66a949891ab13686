// Converts the values of messages to bytes and back with Boost.Serialization: the one format of messages between ranks.
// The bytes travel only between ranks of one job, on machines of one kind: they have no version and no byte order.
// Bytes that were cut off, or that claim more elements than there are bytes, are an error. Ranks compare their programs
// before the first such message.
//
// A type is sent as the bytes that it has in memory (kSentAsBytes) or member by member (kSentByMembers). For the
// latter the type needs, in boost::serialization,
// template <class Archive> void serialize(Archive& archive, Type& value, unsigned)
// It names all members in a structured binding, so that a forgotten member does not compile, and passes them to
// send_members().
#pragma once

#include <array>
#include <boost/archive/binary_iarchive.hpp>
#include <boost/archive/binary_oarchive.hpp>
#include <boost/serialization/string.hpp>
#include <boost/serialization/vector.hpp>
#include <concepts>
#include <cstdint>
#include <streambuf>
#include <string>
#include <type_traits>

#include "comm/message.h"
#include "core/geometry/grid.h"

namespace tessera::comm {

/// Whether values of this type are sent as the bytes that they have in memory; a vector of them then costs one copy.
/// Specialise it for structures without pointers, several at once with kIsOneOf.
template <class T>
inline constexpr bool kSentAsBytes = std::is_enum_v<T>;
template <class T, std::size_t kSize>
inline constexpr bool kSentAsBytes<std::array<T, kSize>> = std::is_arithmetic_v<T>;

/// Whether the type has a serialize(). Specialise it like kSentAsBytes.
template <class T>
inline constexpr bool kSentByMembers = false;
template <class T>
inline constexpr bool kSentByMembers<Grid<T>> = true;

template <class T, class... Types>
inline constexpr bool kIsOneOf = (std::same_as<T, Types> || ...);

/// Writes or reads the members one after the other.
template <class Archive, class... Members>
void send_members(Archive& archive, Members&... members) {
  (archive & ... & members);
}

/// Throws the EnvironmentError for a message that this program does not understand.
[[noreturn]] void refuse_message();

/// A stream buffer that reads the bytes of a message.
class MessageBuffer : public std::streambuf {
 public:
  explicit MessageBuffer(const Bytes& bytes) {
    char* begin = const_cast<char*>(bytes.data());  // std::streambuf reads through pointers to non-const
    setg(begin, begin, begin + bytes.size());
  }
  std::size_t left() const { return std::size_t(egptr() - gptr()); }
};

inline constexpr unsigned kBareArchive = boost::archive::no_header | boost::archive::no_codecvt;

/// A binary archive of Boost for reading. Before it allocates memory for a count, it checks that the rest of the
/// message can hold that many elements. Throws EnvironmentError, or boost::archive::archive_exception where the message
/// ends early.
class MessageReader : public boost::archive::binary_iarchive_impl<MessageReader, char, std::char_traits<char>> {
  using Base = boost::archive::binary_iarchive_impl<MessageReader, char, std::char_traits<char>>;
  friend class boost::archive::detail::interface_iarchive<MessageReader>;
  friend class boost::archive::load_access;

 public:
  explicit MessageReader(MessageBuffer& buffer) : Base(buffer, kBareArchive), buffer_(buffer) { init(kBareArchive); }

 private:
  template <class T>
  void load_override(T& value) {
    Base::load_override(value);
  }
  /// Refuses a count above the bytes left: each element takes at least one byte.
  void load_override(boost::serialization::collection_size_type& count) {
    Base::load_override(count);
    if (count > buffer_.left()) refuse_message();
  }
  void load_override(std::string& text) {
    boost::serialization::collection_size_type count(0);
    load_override(count);
    text.resize(count);
    load_binary(text.data(), count);
  }
  void load_override(bool& value) {
    char byte = 0;
    load_binary(&byte, 1);
    if (byte != 0 && byte != 1) refuse_message();
    value = byte == 1;
  }

  MessageBuffer& buffer_;
};

/// A binary archive of Boost for writing; it writes texts in the form that MessageReader reads.
class MessageWriter : public boost::archive::binary_oarchive_impl<MessageWriter, char, std::char_traits<char>> {
  using Base = boost::archive::binary_oarchive_impl<MessageWriter, char, std::char_traits<char>>;
  friend class boost::archive::detail::interface_oarchive<MessageWriter>;
  friend class boost::archive::save_access;

 public:
  explicit MessageWriter(std::streambuf& buffer) : Base(buffer, kBareArchive) { init(kBareArchive); }

 private:
  template <class T>
  void save_override(T& value) {
    Base::save_override(value);
  }
  void save_override(const std::string& text) {
    const boost::serialization::collection_size_type count(text.size());
    Base::save_override(count);
    save_binary(text.data(), text.size());
  }
};

}  // namespace tessera::comm

BOOST_SERIALIZATION_REGISTER_ARCHIVE(tessera::comm::MessageReader)
BOOST_SERIALIZATION_REGISTER_ARCHIVE(tessera::comm::MessageWriter)
BOOST_SERIALIZATION_USE_ARRAY_OPTIMIZATION(tessera::comm::MessageReader)
BOOST_SERIALIZATION_USE_ARRAY_OPTIMIZATION(tessera::comm::MessageWriter)

namespace boost::serialization {

template <class T>
requires tessera::comm::kSentAsBytes<T>
struct is_bitwise_serializable<T> : mpl::true_ {
  static_assert(std::is_trivially_copyable_v<T>);
};

template <class T>
requires tessera::comm::kSentAsBytes<T>
struct implementation_level_impl<const T> {
  using tag = mpl::integral_c_tag;
  using type = mpl::int_<primitive_type>;
  static constexpr int value = primitive_type;
};

// Values are written without version and without identity (each is written once).
template <class T>
requires tessera::comm::kSentByMembers<T>
struct implementation_level_impl<const T> {
  using tag = mpl::integral_c_tag;
  using type = mpl::int_<object_serializable>;
  static constexpr int value = object_serializable;
};

template <class T>
requires tessera::comm::kSentByMembers<T>
struct tracking_level<T> {
  using tag = mpl::integral_c_tag;
  using type = mpl::int_<track_never>;
  static constexpr int value = track_never;
};

template <class Archive, class T>
void serialize(Archive& archive, tessera::Grid<T>& grid, unsigned) {
  int width = grid.width();
  int height = grid.height();
  std::vector<T> values;
  if constexpr (Archive::is_loading::value) {
    tessera::comm::send_members(archive, width, height, values);
    const bool fits = width >= 0 && height >= 0 && values.size() == std::size_t(width) * std::size_t(height);
    if (!fits) tessera::comm::refuse_message();
    grid = tessera::Grid<T>(width, height);
    grid.data() = std::move(values);
  } else {
    tessera::comm::send_members(archive, width, height, grid.data());
  }
}

}  // namespace boost::serialization
