// Outlines in the message from a drawer.
#include <gtest/gtest.h>

#include <rapidcheck/gtest.h>

#include "artwork/protocol/outlines_codec.h"

namespace tessera {
namespace test_outlines_codec {

SvgOutlines some_outlines(int outlines) {
  SvgOutlines found{.outlines = {},
                    .unread_elements = 3,
                    .undrawn_elements = {"a", "b"},
                    .masked_elements = {"masked"},
                    .far_elements = {"far", ""},
                    .says_unit = true,
                    .page_mm = {210, 297},
                    .program = "Inkscape 0.91",
                    .program_px_per_inch = 90};
  for (int i = 0; i < outlines; ++i) {
    found.outlines.push_back(
        {.name = "r" + std::to_string(i),
         .filled = i % 2 == 0,
         .even_odd = i % 3 == 0,
         .steps = {{'M', {{{1. * i, 2}}}}, {'C', {{{3, 4}, {5, 6}, {7, 8}}}}, {'L', {{{-9.5, 1e5}}}}, {'Z'}}});
  }
  return found;
}

TEST(OutlinesCodec, WhatArrivesIsWhatWasSent) {
  const SvgOutlines sent = some_outlines(4), got = decode_outlines(encode_outlines(sent));
  EXPECT_EQ(got.unread_elements, 3);
  EXPECT_EQ(got.undrawn_elements, sent.undrawn_elements);
  EXPECT_EQ(got.masked_elements, sent.masked_elements);
  EXPECT_EQ(got.far_elements, sent.far_elements);
  EXPECT_TRUE(got.says_unit);
  EXPECT_EQ(got.page_mm, sent.page_mm);
  EXPECT_EQ(got.program, sent.program);
  EXPECT_EQ(got.program_px_per_inch, 90);
  ASSERT_EQ(got.outlines.size(), 4u);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(got.outlines[i].name, sent.outlines[i].name);
    EXPECT_EQ(got.outlines[i].filled, sent.outlines[i].filled);
    EXPECT_EQ(got.outlines[i].even_odd, sent.outlines[i].even_odd);
    ASSERT_EQ(got.outlines[i].steps.size(), 4u);
    for (std::size_t k = 0; k < 4; ++k) {
      EXPECT_EQ(got.outlines[i].steps[k].command, sent.outlines[i].steps[k].command);
      EXPECT_EQ(got.outlines[i].steps[k].points, sent.outlines[i].steps[k].points);
    }
  }
}

RC_GTEST_PROP(OutlinesCodec, GarbledBytesAreRefusedOrAreOutlines, ()) {
  std::vector<std::uint8_t> bytes = encode_outlines(some_outlines(3));
  const int changes = *rc::gen::inRange(1, 5);
  for (int i = 0; i < changes; ++i)
    bytes[*rc::gen::inRange<std::size_t>(0, bytes.size())] = *rc::gen::arbitrary<std::uint8_t>();
  bytes.resize(*rc::gen::inRange<std::size_t>(0, bytes.size() + 1));
  try {
    for (const SvgOutline& outline : decode_outlines(bytes).outlines)
      RC_ASSERT(outline.steps.empty() || outline.steps.front().command == 'M');
  } catch (const std::runtime_error&) {
  }
}

/// A closing step takes one byte in the message, but many in memory.
TEST(OutlinesCodec, MoreStepsThanAFileMayHaveAreRefused) {
  SvgOutlines outlines = some_outlines(2);
  for (SvgOutline& outline : outlines.outlines) outline.steps.resize(kMostOutlineSteps / 2, {'Z'});
  EXPECT_EQ(decode_outlines(encode_outlines(outlines)).outlines.size(), 2u);
  outlines.outlines[1].steps.push_back({'Z'});
  EXPECT_THROW(decode_outlines(encode_outlines(outlines)), std::runtime_error);
}

TEST(OutlinesCodec, CutOffOrLongerBytesAreRefused) {
  const std::vector<std::uint8_t> bytes = encode_outlines(some_outlines(2));
  for (std::size_t count = 0; count < bytes.size(); ++count)
    EXPECT_THROW(decode_outlines(std::span(bytes).first(count)), std::runtime_error) << count;
  std::vector<std::uint8_t> longer = bytes;
  longer.push_back(0);
  EXPECT_THROW(decode_outlines(longer), std::runtime_error);
}

}  // namespace test_outlines_codec
}  // namespace tessera
