// Outlines and contact of pieces as bytes for a page.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "core/geometry/polygon.h"
#include "report/outline_codec.h"
#include "support/random_curves.h"

namespace tessera {
namespace test_outline_codec {

using Rings = std::vector<std::vector<Vec2>>;

/// Reads the bytes as the page does (web/src/model/outlines.ts).
class Decoder {
 public:
  explicit Decoder(const std::vector<std::uint8_t>& bytes) : bytes_(bytes) {}

  bool ended() const { return at_ == bytes_.size(); }

  Rings piece() {
    Rings rings(number());
    std::int64_t x = 0, y = 0;
    for (std::vector<Vec2>& ring : rings) {
      ring.resize(number());
      for (Vec2& p : ring) {
        x += step();
        y += step();
        p = {float(x) / 8, float(y) / 8};
      }
    }
    return rings;
  }

 private:
  std::uint64_t number() {
    std::uint64_t value = 0;
    for (int shift = 0;; shift += 7) {
      const std::uint8_t byte = bytes_.at(at_++);
      value |= std::uint64_t(byte & 127) << shift;
      if (byte < 128) return value;
    }
  }
  std::int64_t step() {
    const std::uint64_t coded = number();
    return std::int64_t(coded >> 1) ^ -std::int64_t(coded & 1);
  }

  const std::vector<std::uint8_t>& bytes_;
  std::size_t at_ = 0;
};

RC_GTEST_PROP(OutlineCodec, rings_come_back_to_a_sixteenth_of_a_px, ()) {
  Rings rings(*rc::gen::inRange(0, 4));
  for (std::vector<Vec2>& ring : rings) {
    ring.resize(*rc::gen::inRange<std::size_t>(0, 50));
    for (Vec2& p : ring) {
      p = {float(*rc::gen::inRange(-2000000, 4000000)) / 100, float(*rc::gen::inRange(-2000000, 4000000)) / 100};
    }
  }
  std::vector<std::uint8_t> bytes;
  append_outline(rings, bytes);
  Decoder decoder(bytes);
  const Rings read = decoder.piece();
  RC_ASSERT(decoder.ended());
  RC_ASSERT(read.size() == rings.size());
  for (std::size_t k = 0; k < rings.size(); ++k) {
    RC_ASSERT(read[k].size() == rings[k].size());
    for (std::size_t i = 0; i < rings[k].size(); ++i) RC_ASSERT(norm(read[k][i] - rings[k][i]) < 0.09f);
  }
}

JudgedPiece square_with_middles(Vec2 corner) {
  JudgedPiece piece;
  std::vector<Vec2> curve;
  for (const Vec2 p : {Vec2{0, 0}, {5, 0}, {10, 0}, {10, 5}, {10, 10}, {5, 10}, {0, 10}, {0, 5}})
    curve.push_back(corner + p);
  piece.outline_px.curves = {curve};
  return piece;
}

TEST(OutlineCodec, points_on_straight_sides_are_left_out_and_their_distances_averaged) {
  const std::vector<float> distances = {1, 2, 4, 4, 0.25f, 0.25f, 0, 0, 3, 3, 3, 3, 3, 3, 3, 3};
  const PieceBlocks blocks = piece_blocks({square_with_middles({2, 3}), square_with_middles({30, 3})}, distances, 4);
  Decoder decoder(blocks.outlines);
  EXPECT_EQ(decoder.piece(), (Rings{{{2, 3}, {12, 3}, {12, 13}, {2, 13}}}));
  EXPECT_EQ(decoder.piece(), (Rings{{{30, 3}, {40, 3}, {40, 13}, {30, 13}}}));
  EXPECT_TRUE(decoder.ended());
  EXPECT_EQ(blocks.contact, (std::vector<std::uint8_t>{24, 255, 4, 0, 48, 48, 48, 48}))
      << "means of 1.5 px, out of reach, 0.25 px, 0 px; the second piece has its own distances";
}

}  // namespace test_outline_codec
}  // namespace tessera
