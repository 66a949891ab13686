// The bounds of a JSON text are checked from its characters, whatever parts it comes in. Files are read in blocks.
#include "text/json_bounds.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <nlohmann/json.hpp>

#include "core/base/digest.h"
#include "support/input_error.h"
#include "support/scratch_folder.h"
#include "text/json_file.h"

namespace tessera {
namespace test_json_bounds {

using nlohmann::json;

std::string refusal(const std::string& text, const JsonBounds& bounds) {
  return test::message_of([&] { check_json(text, bounds); });
}

/// Random lists, objects, numbers, and texts with every character that must be escaped.
json random_json(int levels) {
  const int kind = *rc::gen::inRange(0, levels > 0 ? 5 : 3);
  if (kind == 0) return *rc::gen::arbitrary<int>();
  if (kind == 1) return *rc::gen::container<std::string>(rc::gen::elementOf(std::string("ab\"\\[]{},: \n")));
  if (kind == 2) return nullptr;
  json value = kind == 3 ? json::array() : json::object();
  for (int i = *rc::gen::inRange(0, 4); i > 0; --i) {
    if (kind == 3)
      value.push_back(random_json(levels - 1));
    else
      value[*rc::gen::elementOf(std::vector<std::string>{"a", "b,", "\"", "[\\"})] = random_json(levels - 1);
  }
  return value;
}

/// The depth of nested lists and objects.
std::size_t levels_of(const json& value) {
  std::size_t most = 0;
  if (!value.is_structured()) return 0;
  for (const json& part : value) most = std::max(most, levels_of(part));
  return most + 1;
}

std::size_t members_of(const json& value) {
  std::size_t most = value.is_object() ? value.size() : 0;
  for (const json& part : value.is_structured() ? value : json::array()) most = std::max(most, members_of(part));
  return most;
}

std::size_t values_of(const json& value) {
  std::size_t count = 1;
  for (const json& part : value.is_structured() ? value : json::array()) count += values_of(part);
  return count;
}

RC_GTEST_PROP(JsonBounds, AreThoseOfTheTree, ()) {
  const json value = random_json(5);
  const std::string text = value.dump(*rc::gen::element(-1, 0, 2));
  const std::size_t levels = levels_of(value), members = members_of(value);
  RC_ASSERT(refusal(text, {.levels = levels}) == "");
  if (levels > 0) RC_ASSERT(refusal(text, {.levels = levels - 1}) != "");
  RC_ASSERT(refusal(text, {.members = std::max<std::size_t>(1, members)}) == "");
  if (members > 1) RC_ASSERT(refusal(text, {.members = members - 1}) != "");
  // Each empty list or object may count for one more value.
  RC_ASSERT(refusal(text, {.values = 2 * values_of(value)}) == "");
  if (values_of(value) > 2) RC_ASSERT(refusal(text, {.values = values_of(value) / 2 - 1}) != "");
}

RC_GTEST_PROP(JsonBounds, DoNotDependOnTheParts, ()) {
  const std::string text = random_json(5).dump();
  const JsonBounds bounds{.values = 8, .levels = 3, .members = 2, .token_bytes = 6};
  const std::string parted = test::message_of([&] {
    JsonScan scan(bounds);
    for (std::size_t at = 0; at < text.size();) {
      const std::size_t part = std::min(text.size() - at, *rc::gen::inRange<std::size_t>(1, 9));
      scan.take(std::span(text).subspan(at, part));
      at += part;
    }
  });
  RC_ASSERT(parted == refusal(text, bounds));
}

TEST(JsonBounds, SayWhatWasFound) {
  EXPECT_EQ(refusal("[1, 2, 3]", {.values = 2}), "found more than 2 values; allowed: 2 or fewer");
  EXPECT_EQ(refusal("[[[]]]", {.levels = 2}),
            "found more than 2 levels of lists and objects in each other; allowed: 2 or fewer");
  EXPECT_EQ(refusal(R"({"a":1,"a":2})", {.members = 1}),
            "found more than 1 members of one object; allowed: 1 or fewer");
  EXPECT_EQ(refusal(R"(["[[[[", "\"[[", 12345])", {.levels = 1, .token_bytes = 5}), "");
  EXPECT_EQ(refusal("[123456]", {.token_bytes = 5}),
            "found more than 5 bytes in a text or number; allowed: 5 or fewer");
}

TEST(JsonFile, IsTheWholeFileAndItsDigest) {
  const test::ScratchFolder folder;
  for (const std::size_t bytes : {0, 1, 7, 8, 1000, (1 << 18) - 1, 1 << 18, (1 << 18) + 3, 1 << 20}) {
    std::string text(bytes, ' ');
    for (std::size_t i = 0; i < bytes; i += 3) text[i] = char('a' + i % 26);
    JsonFile file{FileBlocks(folder.write("a.json", text), 1 << 20)};
    const std::string read{std::istreambuf_iterator<char>(file.stream()), {}};
    EXPECT_EQ(read, text);
    Digest digest;
    digest.add_all(std::span<const char>(text));
    EXPECT_EQ(file.digest(), digest.value()) << bytes;
  }
  const std::string path = folder.write("a.json", std::string((1 << 20) + 1, ' '));
  EXPECT_EQ(test::message_of([&] { FileBlocks(path, 1 << 20); }), path + ": found 1048577 bytes, allowed: 1048576");
}

}  // namespace test_json_bounds
}  // namespace tessera
