// The command line in the records of a run can be given to a shell again.
#include "cli/command_line.h"

#include <gtest/gtest.h>

namespace tessera::cli {
namespace {

TEST(CommandLine, plain_words_stand_as_they_are) {
  EXPECT_EQ(quoted_command({"./tessera", "collage", "a-b_c.toml", "--set", "seed=3", "--out=x/y,z:1"}),
            "./tessera collage a-b_c.toml --set seed=3 --out=x/y,z:1");
}

TEST(CommandLine, others_are_quoted) {
  EXPECT_EQ(quoted_command({"tessera", "", "a b", "$(rm)", "it's", "pieces.scale_px=[14, 90]", "~"}),
            "tessera '' 'a b' '$(rm)' 'it'\\''s' 'pieces.scale_px=[14, 90]' '~'");
}

TEST(CommandLine, of_this_process_begins_with_its_program) {
  EXPECT_NE(own_command_line().find("test_command_line"), std::string::npos) << own_command_line();
}

}  // namespace
}  // namespace tessera::cli
