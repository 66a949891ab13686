// Encodes values as the bytes of a message and decodes them.
#pragma once

#include "comm/archive.h"

namespace tessera::comm {
namespace detail {

/// A stream buffer that only counts the bytes written to it.
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

/// A stream buffer that appends the bytes written to it to a vector.
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

}  // namespace detail

/// The bytes of a value. Writes it twice, first to count: the one allocation is exact, which matters for the field of a
/// large canvas.
template <class T>
Bytes encode(const T& value) {
  detail::CountingBuffer counter;
  MessageWriter(counter) << value;
  Bytes bytes;
  bytes.reserve(counter.count());
  detail::AppendingBuffer appender(bytes);
  MessageWriter(appender) << value;
  return bytes;
}

/// The value whose encode() gave `bytes`. Throws EnvironmentError where the bytes cannot be that: they end early, hold
/// more, or claim to hold more.
template <class T>
T decode(const Bytes& bytes) {
  MessageBuffer buffer(bytes);
  T value{};
  try {
    MessageReader(buffer) >> value;
  } catch (const boost::archive::archive_exception&) {
    refuse_message();
  }
  if (buffer.left() > 0) refuse_message();
  return value;
}

}  // namespace tessera::comm
