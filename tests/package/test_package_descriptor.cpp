// Descriptors of the public library: PAD's, and one by a user.
#include <gtest/gtest.h>

#include <stdexcept>

#include "sample_outlines.h"

namespace tessera {
namespace test_package_descriptor {

using matching::Description;
using matching::Matrix;
using matching::Outline;
using test::error_of;

/// The roundness of a shape: 1 for a circle.
class Roundness : public matching::Descriptor {
 public:
  std::string name() const override { return "roundness"; }
  Description describe(const Outline& outline) const override {
    if (outline.curves[0].points.size() == 3) throw std::logic_error("no triangles");
    return {4 * M_PI * area_of(outline) / std::pow(length_of(outline), 2)};
  }
  double distance(const Description& query, const Description& known) const override {
    return std::abs(query[0] - known[0]);
  }
};

TEST(PackageDescriptor, OneOfAUser) {
  const Outline square = matching::make_outline({{{0, 0}, {1, 0}, {1, 1}, {0, 1}}});
  const Matrix matrix = distance_matrix(Roundness(), {test::circle(1)}, {test::circle(9), square, square});
  ASSERT_EQ(matrix.rows, 1u);
  ASSERT_EQ(matrix.columns, 3u);
  EXPECT_NEAR(matrix(0, 0), 0, 1e-9);
  EXPECT_NEAR(matrix(0, 1), 1 - M_PI / 4, 1e-3);
  EXPECT_DOUBLE_EQ(matrix(0, 1), matrix(0, 2));
}

TEST(PackageDescriptor, PadTellsShapesApart) {
  std::vector<Outline> known, turned;
  for (std::uint32_t seed = 0; seed < 6; ++seed) {
    known.push_back(test::random_outline(seed));
    turned.push_back(test::mapped(known.back(), test::similarity(40, 1 + seed, 5, 6)));
  }
  const std::unique_ptr<matching::Descriptor> pad = matching::make_pad_descriptor();
  EXPECT_EQ(pad->name(), "pad");
  const Matrix matrix = distance_matrix(*pad, turned, known);
  for (std::size_t i = 0; i < 6; ++i) {
    EXPECT_LT(matrix(i, i), 0.02) << i;
    for (std::size_t k = 0; k < 6; ++k) EXPECT_TRUE(i == k || matrix(i, k) > 2 * matrix(i, i)) << i << " " << k;
  }
}

TEST(PackageDescriptor, WhatPadCannotTell) {
  const std::unique_ptr<matching::Descriptor> pad = matching::make_pad_descriptor();
  const auto distance = [&](const Outline& query, const Outline& known) {
    return distance_matrix(*pad, {query}, {known})(0, 0);
  };
  const Outline square = matching::make_outline({{{0, 0}, {1, 0}, {1, 1}, {0, 1}}});
  EXPECT_NEAR(distance(test::circle(1), test::circle(5)), 0, 1e-3);  // size does not matter
  EXPECT_NEAR(distance(test::circle(1), square), 0.06, 0.02);
  EXPECT_NEAR(distance(square, test::circle(1)), 0.19, 0.02);
  const Outline line{{{{{0, 0}, {1, 0}}, false}}};
  EXPECT_DOUBLE_EQ(distance(line, line), 2);
  EXPECT_DOUBLE_EQ(distance(line, square), 2);
  EXPECT_DOUBLE_EQ(distance(square, line), 2);
}

TEST(PackageDescriptor, BadInput) {
  const std::unique_ptr<matching::Descriptor> pad = matching::make_pad_descriptor();
  const Outline good = test::circle(1);
  EXPECT_EQ(error_of([&] {
              distance_matrix(*pad, {good}, {good, {}});
            }),
            "known outline 1: an outline without curves; allowed: 1 or more");
  EXPECT_EQ(error_of([&] {
              pad->distance({1, 2}, {});
            }),
            "a description of PADs: found 2 numbers that do not make up PADs, allowed: what describe() returned");
  EXPECT_EQ(error_of([&] { pad->distance({1e300, 2, 1}, {}); }).substr(0, 37), "a description of PADs: found 3 number");
  EXPECT_EQ(error_of([] { matching::make_pad_descriptor({.levels = 9}); }), "levels: found 9, allowed: 2 to 6");
  EXPECT_TRUE(distance_matrix(*pad, {}, {good}).values.empty());
  // An exception of a user's own descriptor comes back unchanged.
  const Outline triangle = matching::make_outline({{{0, 0}, {1, 0}, {0, 1}}});
  EXPECT_THROW(distance_matrix(Roundness(), {triangle}, {}), std::logic_error);
}

}  // namespace test_package_descriptor
}  // namespace tessera
