// Open MPI is told to avoid copies between processes where the kernel refuses them, and only there.
#include "comm/refused_copies.h"

#include <gtest/gtest.h>
#include <seccomp.h>

#include <cerrno>
#include <cstdlib>
#include <string>

#include "support/limited_child.h"

namespace tessera::comm {
namespace test_refused_copies {

constexpr const char* kMechanism = "OMPI_MCA_btl_vader_single_copy_mechanism";

/// Acts as a container's filter: the system call exists but is forbidden.
void refuse_copies() {
  const scmp_filter_ctx filter = seccomp_init(SCMP_ACT_ALLOW);
  seccomp_rule_add(filter, SCMP_ACT_ERRNO(EPERM), SCMP_SYS(process_vm_readv), 0);
  if (seccomp_load(filter) != 0) std::abort();
  seccomp_release(filter);
}

std::string mechanism() {
  const char* value = std::getenv(kMechanism);
  return value ? value : "not set";
}

TEST(RefusedCopies, AreNotTried) {
  const auto report = tessera::test::in_child([] {
    ::unsetenv(kMechanism);
    refuse_copies();
    do_without_refused_copies();
    return mechanism();
  });
  EXPECT_EQ(report.said, "none") << report.death;
}

TEST(RefusedCopies, WhatTheUserHasSetStays) {
  const auto report = tessera::test::in_child([] {
    ::setenv(kMechanism, "knem", 1);
    refuse_copies();
    do_without_refused_copies();
    return mechanism();
  });
  EXPECT_EQ(report.said, "knem") << report.death;
}

TEST(RefusedCopies, NothingIsSetWhereTheyWork) {
  const auto report = tessera::test::in_child([] {
    ::unsetenv(kMechanism);
    do_without_refused_copies();
    return mechanism();
  });
  EXPECT_EQ(report.said, "not set") << report.death;
}

}  // namespace test_refused_copies
}  // namespace tessera::comm
