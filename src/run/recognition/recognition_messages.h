// The messages between the ranks of a recognition (comm/archive.h).
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "comm/messages.h"
#include "core/recognition/recognition.h"

namespace tessera {

/// The curves of one picture, and the side of its pixels in the same units.
struct AskedCurves {
  std::vector<Curve> curves;
  float pixel = 1;
};

/// Message of rank 0 to all others: the queries and the library in which to look for them.
struct RecognitionQuestion {
  std::vector<AskedCurves> queries;
  std::string library;               // the file, which every rank opens itself
  std::uint64_t library_digest = 0;  // ShapeLibrary::content_digest()
  float query_per_drawn_px = 0;      // RecognitionSettings; 0: unknown
  std::uint64_t most = 10;
  /// The library is searched in lots of so many shapes, on any rank, so that the answer is the same on any number of ranks.
  /// Another number of shapes may give another answer.
  std::uint32_t lot_shapes = kSegmentShapes;
};

/// The best shapes for each query, the best first.
using Recognitions = std::vector<std::vector<Recognition>>;

}  // namespace tessera

namespace tessera::comm {

template <class T>
requires kIsOneOf<T, Recognition>
inline constexpr bool kSentAsBytes<T> = true;

template <class T>
requires kIsOneOf<T, Curve, AskedCurves, RecognitionQuestion>
inline constexpr bool kSentByMembers<T> = true;

}  // namespace tessera::comm

namespace boost::serialization {

template <class Archive>
void serialize(Archive& archive, tessera::Curve& curve, unsigned) {
  auto& [points, closed] = curve;
  tessera::comm::send_members(archive, points, closed);
}

template <class Archive>
void serialize(Archive& archive, tessera::AskedCurves& query, unsigned) {
  auto& [curves, pixel] = query;
  tessera::comm::send_members(archive, curves, pixel);
}

template <class Archive>
void serialize(Archive& archive, tessera::RecognitionQuestion& question, unsigned) {
  auto& [queries, library, library_digest, query_per_drawn_px, most, lot_shapes] = question;
  tessera::comm::send_members(archive, queries, library, library_digest, query_per_drawn_px, most, lot_shapes);
}

}  // namespace boost::serialization
