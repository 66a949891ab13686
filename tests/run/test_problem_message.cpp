// The canvas data that rank 0 found arrive at every worker bit for bit.
#include "run/problem_message.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "comm/encode.h"
#include "core/base/error.h"

namespace tessera {
namespace test_problem_message {

template <class T>
Grid<T> grid_of(T first, T second) {
  Grid<T> cells(*rc::gen::inRange(1, 40), *rc::gen::inRange(1, 20), first);
  cells.data().back() = second;
  return cells;
}

TEST(ProblemMessage, arrives_as_it_was) {
  EXPECT_TRUE(rc::check([] {
    const float some = float(*rc::gen::inRange(1, 1000)) / 7;
    ProblemMessage sent{*rc::gen::arbitrary<std::uint64_t>(), *rc::gen::arbitrary<std::uint64_t>(), {}};
    sent.found.size_factor = 1. / double(some);
    sent.found.room_part = double(some) / 3;
    const Grid<Texel> finest = grid_of<Texel>({some, -some, 0.1f, 0.7f}, {0.3f, some, -0.f, 0.f});
    sent.found.overlays.colour = std::make_shared<const ColourTarget>(finest, some);
    sent.found.overlays.sizes = std::make_shared<const SizeMap>(SizeMap{grid_of(some, 0.3f), 1 / some});
    const auto got = comm::decode<ProblemMessage>(comm::encode(sent));
    RC_ASSERT(got.library_digest == sent.library_digest);
    RC_ASSERT(got.overlay_digest == sent.overlay_digest);
    RC_ASSERT(got.found.size_factor == sent.found.size_factor);
    RC_ASSERT(got.found.room_part == sent.found.room_part);
    const ColourTarget& colour = *got.found.overlays.colour;
    RC_ASSERT(colour.texels() == sent.found.overlays.colour->texels());
    RC_ASSERT(colour.levels().back().texels_per_px == sent.found.overlays.colour->levels().back().texels_per_px);
    RC_ASSERT(got.found.overlays.sizes->part.bounds() == sent.found.overlays.sizes->part.bounds());
    RC_ASSERT(got.found.overlays.sizes->part.data() == sent.found.overlays.sizes->part.data());
    RC_ASSERT(got.found.overlays.sizes->cells_per_px == sent.found.overlays.sizes->cells_per_px);
  }));
}

TEST(ProblemMessage, where_there_is_no_picture_none_arrives) {
  const auto got = comm::decode<ProblemMessage>(comm::encode(ProblemMessage{}));
  EXPECT_FALSE(got.found.overlays.colour);
  EXPECT_FALSE(got.found.overlays.sizes);
}

TEST(ProblemMessage, one_that_was_cut_off_is_refused) {
  ProblemMessage sent;
  sent.found.overlays.sizes = std::make_shared<const SizeMap>(SizeMap{Grid<float>(5, 3, 0.3f), 0.7f});
  const comm::Bytes whole = comm::encode(sent);
  for (std::size_t size = 0; size < whole.size(); ++size) {
    const comm::Bytes part(whole.begin(), whole.begin() + std::ptrdiff_t(size));
    EXPECT_THROW(comm::decode<ProblemMessage>(part), EnvironmentError) << size;
  }
}

}  // namespace test_problem_message
}  // namespace tessera
