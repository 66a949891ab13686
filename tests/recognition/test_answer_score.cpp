// The score of an answer, which counts what the similarity leaves out.
#include <gtest/gtest.h>

#include <cmath>

#include "recognition/answer_score.h"

namespace tessera {
namespace test_answer_score {

const Outline kSquare{{{{0, 0}, {2, 0}, {2, 2}, {0, 2}}}};  // perimeter 8
constexpr float kLarge = 32;                                // perimeter four times as long

Recognition answer(float similarity, float query_length) {
  return {ShapeId{0}, Similarity{0, 4, 5, 5}, similarity, query_length};
}

TEST(AnswerScore, AWholeShapeHasItsSimilarity) {
  EXPECT_NEAR(answer_score(answer(0.97f, kLarge), kSquare), 0.97, 1e-6) << "turned and enlarged";
}

TEST(AnswerScore, APieceThatFitsOnALargeShapeHasALowerOne) {
  EXPECT_NEAR(answer_score(answer(1, kLarge / 4), kSquare), 0.5, 1e-6) << "a quarter of it";
}

TEST(AnswerScore, WhatElseTheQueryShowsCostsLessThanSimilarity) {
  EXPECT_NEAR(answer_score(answer(0.25f, 4 * kLarge), kSquare), 0.5, 1e-6);
}

TEST(AnswerScore, HolesCountWithTheOutline) {
  Outline ring = kSquare;
  ring.curves.push_back({{0.5f, 0.5f}, {0.5f, 1.5f}, {1.5f, 1.5f}, {1.5f, 0.5f}});
  EXPECT_NEAR(answer_score(answer(1, kLarge), ring), std::sqrt(8 / 12.), 1e-6);
}

}  // namespace test_answer_score
}  // namespace tessera
