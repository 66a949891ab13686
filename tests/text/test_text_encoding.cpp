// Texts in the encodings that editors and spreadsheets write.
#include "text/text_encoding.h"

#include <gtest/gtest.h>

#include "core/base/error.h"
#include "support/input_error.h"

namespace tessera {
namespace test_text_encoding {

std::string read(const std::string& bytes) {
  return utf8_text({reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()}, "a.txt");
}

std::string mistake(const std::string& bytes) {
  return test::message_of([&] { read(bytes); });
}

constexpr const char* kSave = "; allowed: UTF-8, or UTF-16 with its byte order mark; save the file in UTF-8";

std::string utf16(const std::u16string& text, bool high_byte_first) {
  std::string bytes;
  for (const char16_t unit : text) {
    const char low = char(unit & 0xff), high = char(unit >> 8);
    bytes += high_byte_first ? std::string{high, low} : std::string{low, high};
  }
  return bytes;
}

TEST(TextEncoding, Utf8StaysWithoutItsMark) {
  EXPECT_EQ(read(""), "");
  EXPECT_EQ(read("b\u00e4r\r\n"), "b\u00e4r\r\n");
  EXPECT_EQ(read("\xef\xbb\xbfname"), "name");
}

TEST(TextEncoding, Utf16IsToldByItsMark) {
  const std::u16string text = u"b\u00e4r \u20ac \U0001f98a\n";
  EXPECT_EQ(read("\xff\xfe" + utf16(text, false)), "b\u00e4r \u20ac \U0001f98a\n");
  EXPECT_EQ(read("\xfe\xff" + utf16(text, true)), "b\u00e4r \u20ac \U0001f98a\n");
  EXPECT_EQ(read("\xff\xfe"), "");
}

TEST(TextEncoding, OthersAreRefusedWithTheirLine) {
  EXPECT_EQ(mistake("a\nb\xe4r\n"),
            "a.txt:2: found \"b_r\", which is not UTF-8 but another encoding, such as Latin-1" + std::string(kSave));
  EXPECT_EQ(mistake("a\n" + utf16(u"b", false)),
            "a.txt:2: found a byte of 0, as in UTF-16 without its mark, or in what is no text" + std::string(kSave));
  EXPECT_EQ(mistake("\xff\xfe"
                    "a"),
            "a.txt: found UTF-16 that ends within a character" + std::string(kSave));
  EXPECT_EQ(mistake("\xff\xfe" + utf16(u"a\xd83e", false)),
            "a.txt: found UTF-16 with half a character" + std::string(kSave));
  EXPECT_LT(mistake(std::string(100'000, '\xe4')).size(), 400u);
}

}  // namespace test_text_encoding
}  // namespace tessera
