// Pieces that are too large for the material are named before nest begins to search.
#include <gtest/gtest.h>

#include "run/nesting/nest_fit.h"
#include "support/input_error.h"

namespace tessera {
namespace test_nest_fit {

struct Case {
  NestInput input;
  NestProblem problem;

  void add(const std::string& name, double width, double height, const std::vector<double>& angles_deg) {
    const NestRing outline = {{0, 0}, {width, 0}, {width, height}, {0, height}};
    input.sources.emplace_back().drawing = {name, outline, {}};
    problem.items.push_back({outline, angles_deg, 1});
  }
};

Case of_sheet(double width, double height) {
  Case made;
  made.problem.length = width;
  made.problem.height = height;
  return made;
}

TEST(NestFit, names_what_is_too_large_at_all_angles) {
  Case made = of_sheet(100, 50);
  made.add("small", 10, 10, {0});
  EXPECT_EQ(too_large_text(made.input, made.problem, "a.svg"), "");
  made.add("upright", 20, 80, {0, 90});
  EXPECT_EQ(too_large_text(made.input, made.problem, "a.svg"), "") << "it lies on its side";
  made.add("fixed", 20, 80.5, {0, 180});
  EXPECT_EQ(
      too_large_text(made.input, made.problem, "a.svg"),
      "a.svg: 1 shape of 3 does not fit onto the sheet of 100 x 50 mm at the angles allowed: fixed (20 x 80.5 mm)");
  for (const char* name : {"b", "c", "d", "e", "f", "g"}) made.add(name, 101, 51, {0, 90});
  EXPECT_EQ(
      too_large_text(made.input, made.problem, "a.svg"),
      "a.svg: 7 shapes of 9 do not fit onto the sheet of 100 x 50 mm at the angles allowed: fixed (20 x 80.5 mm), "
      "b (101 x 51 mm), c (101 x 51 mm), d (101 x 51 mm), e (101 x 51 mm) and 2 more");
}

TEST(NestFit, none_that_fits_is_refused_with_the_names) {
  Case made;
  made.problem.height = 5;
  made.add("long", 300, 10, {0});
  made.add("wide", 20, 20, {0, 90});
  EXPECT_EQ(
      test::message_of([&] { too_large_text(made.input, made.problem, "a.svg"); }),
      "a.svg: none of its pieces fits onto the strip of 5 mm at the angles allowed: long (300 x 10 mm), wide (20 x "
      "20 mm)");
}

TEST(NestFit, more_sheets_than_there_are) {
  EXPECT_EQ(stock_text({100, 50, 2}, 3), "the layout takes 3 sheets, and the instance's stock is 2");
  EXPECT_EQ(stock_text({100, 50, 2}, 2), "");
  EXPECT_EQ(stock_text({100, 50, 0}, 9), "");
}

}  // namespace test_nest_fit
}  // namespace tessera
