// The time to match the selectors of a drawing's style sheets is never longer than some seconds.
#include <gtest/gtest.h>

#include "artwork/svg/svg_import.h"
#include "core/base/error.h"
#include "core/base/processor_time.h"
#include "support/artwork_samples.h"

namespace tessera {
namespace test_css_effort {

using test::svg;

std::string repeated(const std::string& text, int times) {
  std::string all;
  for (int i = 0; i < times; ++i) all += text;
  return all;
}

/// `inner` inside 200 nested groups.
std::string deep(const std::string& inner) { return repeated("<g>", 200) + inner + repeated("</g>", 200); }

std::string import(const std::string& sheet, const std::string& body) {
  return import_svg(svg("<style>" + sheet + "</style>" + body), "file", "s", {100, 50});
}

/// Measures processor time, so that other work on the machine does not count.
class Clock {
 public:
  double seconds() const { return processor_time_s() - begin_; }

 private:
  double begin_ = processor_time_s();
};

TEST(CssEffort, SelectorsThatNearlyMatchDeepDrawingsAreQuick) {
  for (const char* selector :
       {"x * * * * rect", "x * * * * * * * * * * rect", "x > * * > * * > * rect", "x ~ * ~ * ~ * ~ * ~ rect",
        "x ~ * * ~ * * ~ * * ~ rect", "x + * * + * * * rect", "x * > * * * ~ rect", ".x * * * :not(.y) * * rect"}) {
    const Clock clock;
    const std::string copy = import(std::string(selector) + "{fill:red}", deep(repeated("<rect/>", 300)));
    EXPECT_EQ(copy.find("red"), std::string::npos) << selector;
    EXPECT_LT(clock.seconds(), 1) << selector;
  }
}

TEST(CssEffort, NumbersOfManySiblingsAreQuick) {
  const Clock clock;
  const std::string copy =
      import("rect:nth-child(20000),rect:nth-last-of-type(20000){fill:red}", repeated("<rect/>", 40000));
  EXPECT_NE(copy.find("red"), std::string::npos);
  EXPECT_LT(clock.seconds(), 2);
}

constexpr double kMostSeconds = 30;  // with a sanitizer and other work on the machine

struct Refused {
  std::string what, sheet, body;
};

/// Selectors that no algorithm can match quickly, and sheets that style many elements in many ways.
std::vector<Refused> refused() {
  const std::string many_rects = repeated("<rect/>", 50000);
  const std::string class_of_many = "<rect class=\"" + repeated("y ", 50) + "x\"/>";
  return {{"nots", "rect" + repeated(":not(", 15) + "y" + repeated(" *)", 15) + "{fill:red}", deep("<rect/>")},
          {"siblings", "x ~ rect{fill:red}", many_rects},
          {"rules", repeated("*{fill:red}", 20000), many_rects},
          {"ancestors", repeated("x *{fill:red}", 20000), deep(many_rects)},
          {"compounds", "*" + repeated("+*", 40000) + "{fill:red}", many_rects},
          {"bytes", "*{font-family:'" + repeated("x", 100000) + "'}", many_rects},
          {"declarations", "*{" + repeated("a:b;", 100000) + "}", many_rects},
          {"classes", repeated(".x", 50000) + "{fill:red}", repeated(class_of_many, 2000)},
          {"comments", repeated(":empty", 50000) + "{fill:red}", "<rect>" + repeated("<!---->", 50000) + "</rect>"},
          {"languages", repeated(":lang(en)", 50000) + "{fill:red}",
           "<g xml:lang=\"en\">" + deep(repeated("<rect/>", 100)) + "</g>"}};
}

TEST(CssEffort, WhatTakesTooLongIsRefused) {
  for (const Refused& drawing : refused()) {
    const Clock clock;
    std::string message;
    try {
      import(drawing.sheet, drawing.body);
    } catch (const InputError& error) {
      message = error.what();
    }
    EXPECT_NE(message.find("file: its style sheets"), std::string::npos) << drawing.what << message;
    EXPECT_NE(message.find("allowed:"), std::string::npos) << drawing.what << message;
    EXPECT_LT(clock.seconds(), kMostSeconds) << drawing.what;
    RecordProperty(drawing.what, std::to_string(clock.seconds()) + " s");
  }
}

/// An attribute that a document type gives to every element counts for each of them.
TEST(CssEffort, DefaultsOfManyElementsAreRefused) {
  const std::string text = "<!DOCTYPE svg [<!ATTLIST rect class CDATA '" + repeated("x ", 30000) +
                           "'>]><svg xmlns=\"http://www.w3.org/2000/svg\"><style>.x{fill:red}</style>" +
                           repeated("<rect/>", 50000) + "</svg>";
  const Clock clock;
  EXPECT_THROW(import_svg(test::Bytes(text.begin(), text.end()), "file", "s", {100, 50}), InputError);
  EXPECT_LT(clock.seconds(), kMostSeconds);
}

}  // namespace test_css_effort
}  // namespace tessera
