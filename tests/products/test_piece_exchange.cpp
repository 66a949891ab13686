// Square pieces of one picture, laid in wrong places, move to where their pictures agree.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <optional>

#include "core/base/portable_math.h"
#include "products/puzzle/laying/piece_exchange.h"
#include "products/puzzle/puzzle_truth.h"

namespace tessera {
namespace test_piece_exchange {

constexpr int kColumns = 4, kRows = 3, kPieces = kColumns * kRows;
constexpr float kSide = 100;

std::array<float, 3> scene(Vec2 p) {
  const float x = p.x / 400, y = p.y / 300;
  return {127 + 60 * std::sin(9 * x + 4 * y) + 60 * std::sin(23 * y - 11 * x),
          127 + 90 * std::sin(7 * y - 3 * x + 2) + 30 * std::sin(31 * x),
          127 + 70 * std::sin(13 * x * y + 5) + 50 * std::sin(17 * x + 19 * y)};
}

std::vector<Vec2> square() { return {{0, 0}, {kSide, 0}, {kSide, kSide}, {0, kSide}}; }

Similarity place(int i) { return {1, 0, kSide * float(i % kColumns), kSide * float(i / kColumns)}; }

class Squares : public testing::Test {
 protected:
  Squares() : scale_(PuzzleScale::of(std::vector<double>(kPieces, double(kSide) * double(kSide)))) {
    scale_.contrast = 60;
    for (int i = 0; i < kPieces; ++i) {
      pieces_.push_back(puzzle_piece(square(), scale_));
      poses_.push_back(place(i));
      paint(i, [&](Vec2 p) { return scene(place(i).apply(p)); });
    }
  }

  template <class ColourAt>
  void paint(int i, const ColourAt& colour_at) {
    std::vector<std::uint8_t> bgra;
    for (int y = 0; y < int(kSide); ++y) {
      for (int x = 0; x < int(kSide); ++x) {
        for (const float c : colour_at(Vec2{float(x) + 0.5f, float(y) + 0.5f})) bgra.push_back(std::uint8_t(c));
        bgra.push_back(255);
      }
    }
    pictures_[std::size_t(i)].emplace(int(kSide), int(kSide), bgra, Similarity{1, 0, 0, 0});
  }

  void exchange(int a, int b) { std::swap(poses_[std::size_t(a)], poses_[std::size_t(b)]); }
  void turn_by_half(int i) {
    Similarity& pose = poses_[std::size_t(i)];
    pose = {-1, 0, pose.tx + kSide, pose.ty + kSide};
  }

  ExchangedPieces exchanged_now() {
    std::vector<PosedPiece> laid;
    for (int i = 0; i < kPieces; ++i) {
      pieces_[std::size_t(i)].picture = pictures_[std::size_t(i)] ? &*pictures_[std::size_t(i)] : nullptr;
      laid.push_back({&pieces_[std::size_t(i)], poses_[std::size_t(i)]});
    }
    return exchanged(laid, scale_, [&] { ++looks_; });
  }

  /// Counts the right pieces. Each pose becomes that of the piece's centre with its size, as agreement() compares them.
  static int right(const std::vector<Similarity>& poses) {
    std::vector<std::optional<Similarity>> found, truth;
    for (int i = 0; i < kPieces; ++i) {
      for (const auto& [pose, to] : {std::pair{poses[std::size_t(i)], &found}, std::pair{place(i), &truth}}) {
        const Vec2 centre = pose.apply({kSide / 2, kSide / 2});
        to->push_back(Similarity{pose.a * kSide, pose.b * kSide, centre.x, centre.y});
      }
    }
    return agreement(found, truth).right;
  }

  PuzzleScale scale_;
  std::vector<PuzzlePiece> pieces_;
  std::vector<Similarity> poses_;
  std::array<std::optional<PiecePicture>, kPieces> pictures_;
  int looks_ = 0;
};

TEST_F(Squares, StayWhereTheyBelong) {
  const ExchangedPieces found = exchanged_now();
  EXPECT_EQ(found.poses, poses_);
  EXPECT_EQ(found.undecided, 0);
  EXPECT_GT(looks_, 0);
}

TEST_F(Squares, GoWhereTheirPicturesAgree) {
  exchange(0, 5);
  exchange(2, 11);
  exchange(5, 7);
  turn_by_half(6);
  turn_by_half(7);
  ASSERT_LT(right(poses_), kPieces);
  const ExchangedPieces found = exchanged_now();
  EXPECT_EQ(right(found.poses), kPieces);
  EXPECT_EQ(found.undecided, 0);
}

/// Starts from random orders. Exchanges of two pieces alone would bring only 34 of these 72 to their places.
TEST_F(Squares, ComeOutOfAWrongOrderAltogether) {
  int right_of_all = 0;
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    for (int i = 0; i < kPieces; ++i) poses_[std::size_t(i)] = place(i);
    for (int i = kPieces - 1; i > 0; --i)
      exchange(i, int(mix_bits(seed * 100 + std::uint64_t(i)) % std::uint64_t(i + 1)));
    right_of_all += right(exchanged_now().poses);
  }
  EXPECT_EQ(right_of_all, 72);
}

TEST_F(Squares, OfOneColourMightLieInEachOthersPlace) {
  const auto plain = [](Vec2) { return std::array<float, 3>{90, 120, 60}; };
  for (const int i : {1, 9}) paint(i, plain);
  const int undecided = exchanged_now().undecided;
  EXPECT_GE(undecided, 2);
  EXPECT_LT(undecided, kPieces);  // their neighbours fit plain squares badly
}

TEST_F(Squares, WithoutPicturesAreLeftAsTheyAre) {
  exchange(0, 5);
  scale_.contrast = 0;
  const ExchangedPieces found = exchanged_now();
  EXPECT_EQ(found.poses, poses_);
  EXPECT_EQ(found.undecided, 0);
}

TEST_F(Squares, OfAnotherSizeKeepTheirPlaces) {
  pieces_[5] = puzzle_piece({{0, 0}, {kSide, 0}, {kSide, 0.8f * kSide}, {0, 0.8f * kSide}}, scale_);
  exchange(0, 1);
  const ExchangedPieces found = exchanged_now();
  EXPECT_EQ(found.poses[5], poses_[5]);
  EXPECT_EQ(found.poses[0], place(0));
}

}  // namespace test_piece_exchange
}  // namespace tessera
