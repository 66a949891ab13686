// A shell can run the command line from the records of a run again.
#include "run/command_line.h"

#include <gtest/gtest.h>

#include "terminal/shell_word.h"

namespace tessera::cli {
namespace test_command_line {

TEST(CommandLine, plain_words_stand_as_they_are) {
  EXPECT_EQ(quoted_command({"./tessera", "collage", "a-b_c.toml", "--set", "seed=3", "--out=x/y,z:1"}),
            "./tessera collage a-b_c.toml --set seed=3 --out=x/y,z:1");
}

TEST(CommandLine, others_are_quoted) {
  EXPECT_EQ(quoted_command({"tessera", "", "a b", "$(rm)", "it's", "pieces.scale_px=[14, 90]", "~"}),
            "tessera '' 'a b' '$(rm)' 'it'\\''s' 'pieces.scale_px=[14, 90]' '~'");
}

TEST(CommandLine, what_cannot_be_printed_is_escaped) {
  EXPECT_EQ(quoted_command({"a\xe4\x1b\n'\\\u00ad\u00e9"}), "$'a\\344\\033\\012\\047\\134\\302\\255\u00e9'");
  EXPECT_EQ(shell_cell("a b'c\"\u00e9"), "a b'c\"\u00e9");
  EXPECT_EQ(shell_cell("a\tb"), "$'a\\011b'");
  EXPECT_EQ(shell_cell("$'x"), "$'$\\047x'") << "else it would be read as what is escaped";
}

TEST(CommandLine, of_this_process_begins_with_its_program) {
  EXPECT_NE(own_command_line().find("test_command_line"), std::string::npos) << own_command_line();
}

}  // namespace test_command_line
}  // namespace tessera::cli
