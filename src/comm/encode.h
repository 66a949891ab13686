// Values to the bytes of a message and back.
#pragma once

#include "comm/archive.h"

namespace tessera::comm {

/// Writes the value twice, once to count: the one allocation is exact, which matters for a large canvas' field.
template <class T>
Bytes encode(const T& value) {
  MessageWriter counter(nullptr);
  counter(value);
  Bytes bytes;
  bytes.reserve(counter.count());
  MessageWriter writer(&bytes);
  writer(value);
  return bytes;
}

/// The value whose encode() gave `bytes`. Throws EnvironmentError where they cannot be that: they end early, hold
/// more, or claim to hold more.
template <class T>
T decode(const Bytes& bytes) {
  MessageReader reader(bytes);
  T value{};
  reader(value);
  reader.expect_end();
  return value;
}

}  // namespace tessera::comm
