#include "text/utf8_text.h"

#include <gtest/gtest.h>

#include "text/json_text.h"

namespace tessera {
namespace test_utf8_text {

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
  EXPECT_EQ(printable_utf8("\xef\xbf\xbe\xef\xbf\xbf"), "______");  // XML does not allow these
}

TEST(PrintableUtf8, ReplacesWhatIsNotSeenOrReordersTheTextRoundIt) {
  for (const char* text : {"\u00ad", "\u034f", "\u061c", "\u0085"})
    EXPECT_EQ(printable_utf8(std::string("a") + text + "b"), "a__b") << text;
  for (const char* text : {"\u2028", "\u2029", "\u202a", "\u202e", "\u2066", "\u2069", "\u200b", "\u200d", "\u200e",
                           "\u206a", "\u2060", "\ufeff", "\ufff9", "\u115f", "\u3164", "\ufdd0"})
    EXPECT_EQ(printable_utf8(std::string("a") + text + "b"), "a___b") << text;
  for (const char* text : {"\U0001d173", "\U000e0041", "\U000e0001", "\U000e0100", "\U0001fffe", "\U0010ffff"})
    EXPECT_EQ(printable_utf8(std::string("a") + text + "b"), "a____b") << text;
  for (const char* text : {"\u2027", "\u202f", "\u00ac", "\u00ae", "\u200a", "\u2010", "\u2070", "\ufffd", "\ufefc",
                           "\u2764\ufe0f", "\U0001f600", "\U000dfffd", "\U000e1000", "שלום"})
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

TEST(JsonPathText, HasEveryByteOfAPath) {
  EXPECT_EQ(json_path_text("out/a b"), R"("out/a b")");
  EXPECT_EQ(json_path_text("a\"\\\n\x1b\u202e"), R"("a\"\\\n\u001b\u202e")");
  EXPECT_EQ(json_path_text("\u00e4\U0001f600"), R"("\u00e4\ud83d\ude00")");
  EXPECT_EQ(json_path_text("t\xe4\xffst\xc3"), R"("t\udce4\udcffst\udcc3")");
}

}  // namespace test_utf8_text
}  // namespace tessera
