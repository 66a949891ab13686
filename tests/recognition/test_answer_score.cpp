// The score of an answer: what the similarity leaves out of account.
#include <gtest/gtest.h>

#include <cmath>

#include "recognition/answer_score.h"

namespace tessera {
namespace test_answer_score {

const Outline kSquare{{{{0, 0}, {2, 0}, {2, 2}, {0, 2}}}};   // 8 long
const Curve kLarge{{{0, 0}, {8, 0}, {8, 8}, {0, 8}}, true};  // four times as long

Recognition answer(float similarity, Similarity query_from_shape) { return {ShapeId{0}, query_from_shape, similarity}; }

TEST(AnswerScore, AWholeShapeHasItsSimilarity) {
  EXPECT_NEAR(answer_score(answer(0.97f, {0, 4, 5, 5}), {kLarge}, kSquare), 0.97, 1e-6) << "turned and enlarged";
}

TEST(AnswerScore, APieceThatFitsOnALargeShapeHasALowerOne) {
  const Curve side{{{0, 0}, {8, 0}}, false};
  EXPECT_NEAR(answer_score(answer(1, {4, 0, 0, 0}), {side}, kSquare), 0.5, 1e-6) << "a quarter of it";
}

TEST(AnswerScore, WhatElseTheQueryShowsCostsLessThanSimilarity) {
  EXPECT_NEAR(answer_score(answer(0.25f, {4, 0, 0, 0}), {kLarge, kLarge, kLarge, kLarge}, kSquare), 0.5, 1e-6);
}

TEST(AnswerScore, HolesCountWithTheOutline) {
  Outline ring = kSquare;
  ring.curves.push_back({{0.5f, 0.5f}, {0.5f, 1.5f}, {1.5f, 1.5f}, {1.5f, 0.5f}});
  EXPECT_NEAR(answer_score(answer(1, {4, 0, 0, 0}), {kLarge}, ring), std::sqrt(8 / 12.), 1e-6);
}

}  // namespace test_answer_score
}  // namespace tessera
