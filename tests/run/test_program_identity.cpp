#include "run/program_identity.h"

#include <gtest/gtest.h>

namespace tessera {
namespace test_program_identity {

TEST(ProgramIdentity, says_version_commit_and_kernels) {
  EXPECT_TRUE(program_identity().starts_with("tessera "));
  EXPECT_NE(program_identity().find(", commit "), std::string::npos);
  EXPECT_NE(program_identity().find(", kernels "), std::string::npos);
}

}  // namespace test_program_identity
}  // namespace tessera
