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

TEST(PrintableUtf8, ReplacesWhatReordersTheTextRoundIt) {
  for (const char* text : {"\u2028", "\u2029", "\u202a", "\u202e", "\u2066", "\u2069"}) {
    EXPECT_EQ(printable_utf8(std::string("a") + text + "b"), "a___b");
  }
  for (const char* text : {"\u2027", "\u202f", "\u2065", "\u206a", "\u200d", "שלום"})
    EXPECT_EQ(printable_utf8(text), text);
}

TEST(PrintableUtf8, KeepsWhatItIsTold) {
  EXPECT_EQ(printable_utf8("a\nb\tc\x1b\r", "\n"), "a\nb_c__");
  EXPECT_EQ(printable_utf8("a\nb\tc\x1b\r", "\n\t"), "a\nb\tc__");
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
