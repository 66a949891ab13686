#include "text/digest_text.h"

#include <gtest/gtest.h>

#include "core/base/error.h"

namespace tessera {
namespace test_digest_text {

TEST(DigestText, has_sixteen_digits_and_comes_back) {
  EXPECT_EQ(digest_text(0xab), "00000000000000ab");
  for (const std::uint64_t digest : {std::uint64_t(0), std::uint64_t(0x0123456789abcdef), ~std::uint64_t(0)})
    EXPECT_EQ(digest_of_text(digest_text(digest)), digest);
}

TEST(DigestText, what_is_no_digest_is_refused) {
  for (const char* text : {"", "-1", "0x1", "12345678 ", "123456789abcdef01"})
    EXPECT_THROW(digest_of_text(text), InputError) << text;
}

}  // namespace test_digest_text
}  // namespace tessera
