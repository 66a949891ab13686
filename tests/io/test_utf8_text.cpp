#include "io/utf8_text.h"

#include <gtest/gtest.h>

namespace tessera::io {
namespace {

TEST(CutUtf8, NeverEndsInsideACharacter) {
  const std::string text = "aé€";  // 1, 2 and 3 bytes
  const std::string expected[] = {"", "a", "a", "aé", "aé", "aé", "aé€", "aé€"};
  for (std::size_t most = 0; most < std::size(expected); ++most)
    EXPECT_EQ(cut_utf8(text, most), expected[most]) << most;
}

TEST(PrintableUtf8, ReplacesControlsAndBrokenBytes) {
  EXPECT_EQ(printable_utf8("é\n\x1b[2J"), "é__[2J");
  EXPECT_EQ(printable_utf8("\xc3"), "_");            // cut off
  EXPECT_EQ(printable_utf8("\xe0\x80\xaf"), "___");  // overlong
  EXPECT_EQ(printable_utf8("\xed\xa0\x80"), "___");  // a surrogate
  EXPECT_EQ(printable_utf8("\xc2\x85"), "__");       // a C1 control
  EXPECT_EQ(printable_utf8("\xf9\x80\x80\x80"), "____");
  EXPECT_EQ(printable_utf8("\xef\xbf\xbe\xef\xbf\xbf"), "______");  // which XML does not allow
}

TEST(IsUtf8, AsksNotWhatTheCharactersAre) {
  EXPECT_TRUE(is_utf8(""));
  EXPECT_TRUE(is_utf8("aé€\n\x1b\xc2\x85"));
  EXPECT_FALSE(is_utf8("a\xe4t"));
  EXPECT_FALSE(is_utf8("a\xc3"));
  EXPECT_TRUE(is_utf8("\xf4\x8f\xbf\xbf"));
  for (const char* beyond : {"\xf5\x80\x80\x80", "\xf9\xab\xb0\xbf", "\xfc\x80\x80\x80", "\xff"}) {
    EXPECT_FALSE(is_utf8(beyond));
  }
}

}  // namespace
}  // namespace tessera::io
