// The body of a request to refine.
#include <gtest/gtest.h>

#include "serve/refine_request.h"
#include "support/input_error.h"

namespace tessera::serve {
namespace test_refine_request {

std::string refusal(const std::string& body) {
  return test::message_of([&] { parse_refine_request(body); });
}

TEST(RefineRequest, erases_swaps_and_relaxes) {
  const RefineRequest erases = parse_refine_request(
      R"({"result":"a","pieces_digest":"12","action":"erase","pieces":[3,17],"lock":[4],"seed":7})");
  EXPECT_EQ(erases.result, "a");
  EXPECT_EQ(erases.pieces_digest, "12");
  EXPECT_EQ(erases.marks.action, Marks::Action::erase);
  EXPECT_EQ(erases.marks.pieces, (std::vector<int>{3, 17}));
  EXPECT_EQ(erases.marks.locked, (std::vector<int>{4}));
  EXPECT_EQ(erases.seed, 7u);
  const RefineRequest relaxes =
      parse_refine_request(R"({"result":"a","pieces_digest":"12","action":"relax","pieces":[],"lock":[],"seed":null})");
  EXPECT_EQ(relaxes.marks.action, Marks::Action::relax);
  EXPECT_FALSE(relaxes.seed);
}

TEST(RefineRequest, refusals_name_key_found_and_allowed) {
  EXPECT_EQ(refusal("[]"), "the body is no JSON object");
  EXPECT_EQ(refusal("{"), "the body is no JSON object");
  EXPECT_EQ(refusal(""), "the body is no JSON object");
  EXPECT_EQ(refusal("{}"), "result: found nothing, allowed: a text");
  EXPECT_EQ(refusal(R"({"result":"a"})"), "pieces_digest: found nothing, allowed: a text");
  const std::string head = R"({"result":"a","pieces_digest":"12","action":)";
  EXPECT_EQ(refusal(head + R"("burn"})"), R"(action: found "burn", allowed: "erase", "swap" or "relax")");
  EXPECT_EQ(refusal(head + R"("erase","pieces":[],"lock":[]})"),
            "pieces: found [], allowed: at least one piece to erase or to swap");
  EXPECT_EQ(refusal(head + R"("erase","pieces":[1.5],"lock":[]})"),
            "pieces: found 1.5, allowed: a list of numbers of pieces, from 0");
  EXPECT_EQ(refusal(head + R"("erase","pieces":[1]})"),
            "lock: found nothing, allowed: a list of numbers of pieces, from 0");
  EXPECT_EQ(refusal(head + R"("relax","pieces":[],"lock":[],"seed":"; rm"})"),
            R"(seed: found "; rm", allowed: a whole number from 0, or null)");
}

TEST(RefineRequest, deep_lists_are_refused_before_they_are_parsed) {
  EXPECT_NE(refusal(std::string(100'000, '[')), "");
}

}  // namespace test_refine_request
}  // namespace tessera::serve
