// A warp in the message to a drawer: the drawer gets what was sent, or refuses it.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <functional>
#include <limits>

#include "artwork/protocol/warp_codec.h"
#include "core/base/error.h"

namespace tessera {
namespace test_warp_codec {

Warp any_warp() {
  Warp warp{.origin = {-3, 4.5f}, .step = 0.75f, .displacement = {5, 3}, .active = {4, 2, 1}, .falling = false};
  for (int k = 0; k < 15; ++k) warp.displacement.data()[std::size_t(k)] = {float(k), -0.25f * float(k)};
  warp.active(2, 1) = 0;
  return warp;
}

TEST(WarpCodec, WhatWasSentArrives) {
  for (const bool falling : {true, false}) {
    Warp sent = any_warp();
    sent.falling = falling;
    const Warp arrived = decode_warp(encode_warp(sent));
    EXPECT_EQ(arrived.origin, sent.origin);
    EXPECT_EQ(arrived.step, sent.step);
    EXPECT_EQ(arrived.falling, sent.falling);
    EXPECT_EQ(arrived.displacement.bounds(), sent.displacement.bounds());
    EXPECT_EQ(arrived.displacement.data(), sent.displacement.data());
    EXPECT_EQ(arrived.active.bounds(), sent.active.bounds());
    EXPECT_EQ(arrived.active.data(), sent.active.data());
  }
}

TEST(WarpCodec, WhatIsNoWarpIsNotSent) {
  const float endless = std::numeric_limits<float>::infinity(), none = std::nanf("");
  const std::vector<std::function<void(Warp&)>> faults = {
      [](Warp& w) { w = Warp(); },
      [](Warp& w) {
        w.displacement = {1, 3};
      },
      [](Warp& w) {
        w.active = {5, 3};
      },
      [](Warp& w) {
        w.active = {2, 4};
      },
      [](Warp& w) { w.step = 0; },
      [](Warp& w) { w.step = -1; },
      [&](Warp& w) { w.step = none; },
      [&](Warp& w) { w.step = endless; },
      [&](Warp& w) { w.origin.y = none; },
      [&](Warp& w) { w.displacement(4, 2).x = endless; },
      [](Warp& w) { w.displacement(0, 1).y = -1e7f; },
      [](Warp& w) {
        w.displacement = {1025, 1025}, w.active = {1024, 1024};
      },
  };
  for (std::size_t i = 0; i < faults.size(); ++i) {
    Warp warp = any_warp();
    faults[i](warp);
    EXPECT_THROW(encode_warp(warp), InputError) << i;
  }
}

TEST(WarpCodec, WhatIsCutOffOrForgedIsRefused) {
  const std::vector<std::uint8_t> bytes = encode_warp(any_warp());
  for (std::size_t count = 0; count < bytes.size(); ++count) {
    EXPECT_THROW(decode_warp(std::span(bytes).first(count)), InputError) << count;
  }
  std::vector<std::uint8_t> longer = bytes;
  longer.push_back(0);
  EXPECT_THROW(decode_warp(longer), InputError);
  for (const std::size_t at : {12, 16}) {  // the numbers of columns and rows
    for (const std::int32_t count : {-1, 0, 1, 6, 1 << 30, std::numeric_limits<std::int32_t>::max()}) {
      std::vector<std::uint8_t> forged = bytes;
      std::memcpy(forged.data() + at, &count, sizeof count);
      EXPECT_THROW(decode_warp(forged), InputError) << at << ": " << count;
    }
  }
  std::vector<std::uint8_t> forged = bytes;
  const float none = std::nanf("");
  std::memcpy(forged.data() + 24, &none, sizeof none);  // the first displacement
  EXPECT_THROW(decode_warp(forged), InputError);
}

}  // namespace test_warp_codec
}  // namespace tessera
