// Values to bytes and back, by Boost.Serialization. The bytes travel only between ranks of one job, which run the same
// program on the same kind of machine: no version, no byte order, no defence against foreign bytes.
#pragma once

#include <boost/archive/binary_iarchive.hpp>
#include <boost/archive/binary_oarchive.hpp>
#include <streambuf>

#include "comm/message.h"

namespace tessera::comm {
namespace detail {

/// Counts what is written to it.
class CountingBuffer : public std::streambuf {
 public:
  std::size_t count() const { return count_; }

 protected:
  std::streamsize xsputn(const char*, std::streamsize n) override {
    count_ += std::size_t(n);
    return n;
  }
  int_type overflow(int_type c) override {
    ++count_;
    return traits_type::not_eof(c);
  }

 private:
  std::size_t count_ = 0;
};

/// Appends what is written to it.
class AppendingBuffer : public std::streambuf {
 public:
  explicit AppendingBuffer(Bytes& bytes) : bytes_(bytes) {}

 protected:
  std::streamsize xsputn(const char* s, std::streamsize n) override {
    bytes_.insert(bytes_.end(), s, s + n);
    return n;
  }
  int_type overflow(int_type c) override {
    bytes_.push_back(traits_type::to_char_type(c));
    return traits_type::not_eof(c);
  }

 private:
  Bytes& bytes_;
};

class ReadingBuffer : public std::streambuf {
 public:
  explicit ReadingBuffer(const Bytes& bytes) {
    char* begin = const_cast<char*>(bytes.data());  // std::streambuf reads through pointers to non-const
    setg(begin, begin, begin + bytes.size());
  }
};

inline constexpr unsigned kBareArchive = boost::archive::no_header | boost::archive::no_codecvt;

template <class T>
void write_archive(std::streambuf& buffer, const T& value) {
  boost::archive::binary_oarchive archive(buffer, kBareArchive);
  archive << value;
}

}  // namespace detail

/// Writes the value twice, once to count: the one allocation is exact, which matters for a large canvas' field.
template <class T>
Bytes encode(const T& value) {
  detail::CountingBuffer counter;
  detail::write_archive(counter, value);
  Bytes bytes;
  bytes.reserve(counter.count());
  detail::AppendingBuffer appender(bytes);
  detail::write_archive(appender, value);
  return bytes;
}

/// The value whose encode() gave `bytes`; throws boost::archive::archive_exception where they end early.
template <class T>
T decode(const Bytes& bytes) {
  detail::ReadingBuffer buffer(bytes);
  boost::archive::binary_iarchive archive(buffer, detail::kBareArchive);
  T value{};
  archive >> value;
  return value;
}

}  // namespace tessera::comm
