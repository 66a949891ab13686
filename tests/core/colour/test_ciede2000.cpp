#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <numbers>

#include "core/colour/ciede2000.h"

namespace tessera {
namespace test_ciede2000 {

constexpr double kRad = std::numbers::pi / 180;

/// The published formula, with angles.
double with_angles(const Lab& x, const Lab& y) {
  const auto seventh = [](double c) { return std::sqrt(std::pow(c, 7) / (std::pow(c, 7) + std::pow(25., 7))); };
  const double c_mean = (std::hypot(double(x.a), double(x.b)) + std::hypot(double(y.a), double(y.b))) / 2;
  const double g = 0.5 * (1 - seventh(c_mean));
  const double ax = (1 + g) * x.a, ay = (1 + g) * y.a;
  const double cx = std::hypot(ax, double(x.b)), cy = std::hypot(ay, double(y.b));
  const auto hue = [](double a, double b) {
    return a == 0 && b == 0 ? 0. : std::fmod(std::atan2(b, a) / kRad + 360, 360.);
  };
  const double hx = hue(ax, x.b), hy = hue(ay, y.b);
  double dh = hy - hx;
  if (cx * cy == 0) dh = 0;
  if (dh > 180) dh -= 360;
  if (dh < -180) dh += 360;
  double h = hx + hy;
  if (cx * cy != 0) {
    h = std::abs(hx - hy) <= 180 ? h / 2 : (h < 360 ? (h + 360) / 2 : (h - 360) / 2);
  }
  const double dl = y.lightness - x.lightness, dc = cy - cx, dH = 2 * std::sqrt(cx * cy) * std::sin(dh / 2 * kRad);
  const double l = (x.lightness + y.lightness) / 2, c = (cx + cy) / 2;
  const double t = 1 - 0.17 * std::cos((h - 30) * kRad) + 0.24 * std::cos(2 * h * kRad) +
                   0.32 * std::cos((3 * h + 6) * kRad) - 0.2 * std::cos((4 * h - 63) * kRad);
  const double sl = 1 + 0.015 * (l - 50) * (l - 50) / std::sqrt(20 + (l - 50) * (l - 50));
  const double sc = 1 + 0.045 * c, sh = 1 + 0.015 * c * t;
  const double turn = 30 * std::exp(-std::pow((h - 275) / 25, 2));
  const double rt = -std::sin(2 * turn * kRad) * 2 * seventh(c);
  return std::sqrt(std::pow(dl / sl, 2) + std::pow(dc / sc, 2) + std::pow(dH / sh, 2) + rt * (dc / sc) * (dH / sh));
}

rc::Gen<Lab> colours() {
  const auto number = [](int low, int high) {
    return rc::gen::map(rc::gen::inRange(low * 100, high * 100), [](int v) { return float(v) / 100; });
  };
  return rc::gen::construct<Lab>(number(0, 100), number(-120, 120), number(-120, 120));
}

struct Published {
  Lab x, y;
  float difference;
};

/// The 34 pairs of the table by Sharma, Wu and Dalal, except pairs 10 and 14. Their hues are exactly opposite, so either of two hues is
/// their middle, and ours is the other one.
TEST(Ciede2000, GivesPublishedDifferences) {
  const Published table[] = {{{50, 2.6772f, -79.7751f}, {50, 0, -82.7485f}, 2.0425f},
                             {{50, 3.1571f, -77.2803f}, {50, 0, -82.7485f}, 2.8615f},
                             {{50, 2.8361f, -74.02f}, {50, 0, -82.7485f}, 3.4412f},
                             {{50, -1.3802f, -84.2814f}, {50, 0, -82.7485f}, 1},
                             {{50, -1.1848f, -84.8006f}, {50, 0, -82.7485f}, 1},
                             {{50, -0.9009f, -85.5211f}, {50, 0, -82.7485f}, 1},
                             {{50, 0, 0}, {50, -1, 2}, 2.3669f},
                             {{50, -1, 2}, {50, 0, 0}, 2.3669f},
                             {{50, 2.49f, -0.001f}, {50, -2.49f, 0.0009f}, 7.1792f},
                             {{50, 2.49f, -0.001f}, {50, -2.49f, 0.0011f}, 7.2195f},
                             {{50, 2.49f, -0.001f}, {50, -2.49f, 0.0012f}, 7.2195f},
                             {{50, -0.001f, 2.49f}, {50, 0.0009f, -2.49f}, 4.8045f},
                             {{50, -0.001f, 2.49f}, {50, 0.0011f, -2.49f}, 4.7461f},
                             {{50, 2.5f, 0}, {50, 0, -2.5f}, 4.3065f},
                             {{50, 2.5f, 0}, {73, 25, -18}, 27.1492f},
                             {{50, 2.5f, 0}, {61, -5, 29}, 22.8977f},
                             {{50, 2.5f, 0}, {56, -27, -3}, 31.903f},
                             {{50, 2.5f, 0}, {58, 24, 15}, 19.4535f},
                             {{50, 2.5f, 0}, {50, 3.1736f, 0.5854f}, 1},
                             {{50, 2.5f, 0}, {50, 3.2972f, 0}, 1},
                             {{50, 2.5f, 0}, {50, 1.8634f, 0.5757f}, 1},
                             {{50, 2.5f, 0}, {50, 3.2592f, 0.335f}, 1},
                             {{60.2574f, -34.0099f, 36.2677f}, {60.4626f, -34.1751f, 39.4387f}, 1.2644f},
                             {{63.0109f, -31.0961f, -5.8663f}, {62.8187f, -29.7946f, -4.0864f}, 1.263f},
                             {{61.2901f, 3.7196f, -5.3901f}, {61.4292f, 2.248f, -4.962f}, 1.8731f},
                             {{35.0831f, -44.1164f, 3.7933f}, {35.0232f, -40.0716f, 1.5901f}, 1.8645f},
                             {{22.7233f, 20.0904f, -46.694f}, {23.0331f, 14.973f, -42.5619f}, 2.0373f},
                             {{36.4612f, 47.858f, 18.3852f}, {36.2715f, 50.5065f, 21.2231f}, 1.4146f},
                             {{90.8027f, -2.0831f, 1.441f}, {91.1528f, -1.6435f, 0.0447f}, 1.4441f},
                             {{90.9257f, -0.5406f, -0.9208f}, {88.6381f, -0.8985f, -0.7239f}, 1.5381f},
                             {{6.7747f, -0.2908f, -2.4247f}, {5.8714f, -0.0985f, -2.2286f}, 0.6377f},
                             {{2.0776f, 0.0795f, -1.135f}, {0.9033f, -0.0636f, -0.5514f}, 0.9082f}};
  for (const Published& row : table) {
    EXPECT_NEAR(ciede2000(row.x, row.y), row.difference, 2e-4f) << row.difference;
    EXPECT_NEAR(ciede2000(row.y, row.x), row.difference, 2e-4f) << row.difference;
  }
}

TEST(Ciede2000, IsNothingBetweenEquals) {
  EXPECT_EQ(ciede2000({0, 0, 0}, {0, 0, 0}), 0);
  EXPECT_EQ(ciede2000({50, 0, 0}, {50, 0, 0}), 0);
  EXPECT_NEAR(ciede2000({30, 70, -80}, {30, 70, -80}), 0, 1e-4f);
}

RC_GTEST_PROP(Ciede2000Property, IsThatOfTheAngles, ()) {
  const Lab x = *colours(), y = *colours();
  const double expected = with_angles(x, y);
  // Near opposite hues the middle jumps by half a turn.
  const double along = double(x.a) * y.a + double(x.b) * y.b;
  const double product = std::hypot(double(x.a), double(x.b)) * std::hypot(double(y.a), double(y.b));
  RC_PRE(along > -0.999 * product || product < 1e-3);
  RC_ASSERT(std::abs(double(ciede2000(x, y)) - expected) <= 2e-3 + 1e-4 * expected);
}

}  // namespace test_ciede2000
}  // namespace tessera
