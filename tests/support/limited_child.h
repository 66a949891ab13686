// Runs a reader of a foreign file in a child process, and reports whether the child crashed, hung or used too much memory.
#pragma once

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <stdexcept>
#include <string>

#include "core/base/rank_pool.h"

namespace tessera::test {

struct ChildReport {
  std::string said;            // the text that `use` returned
  std::string death;           // empty if the child ended by itself
  std::size_t peak_bytes = 0;  // peak resident memory
};

#ifdef __SANITIZE_ADDRESS__
inline constexpr unsigned kMostProcessorTime_s = 100;  // instrumented programs take five times as long
#else
inline constexpr unsigned kMostProcessorTime_s = 20;
#endif

/// Runs `use`, which returns a text, in a child process. A limit of processor time and, against hanging, one of wall-clock time end the
/// child.
/// Call it while the process has no threads except those of the pool. It ends these first.
template <class Use>
ChildReport in_child(Use use) {
  constexpr unsigned kMost_s = 5 * kMostProcessorTime_s;
  rank_pool().resize(rank_cores());
  int ends[2];
  if (::pipe(ends) != 0) throw std::runtime_error("pipe");
  const pid_t child = ::fork();
  if (child == 0) {
    ::close(ends[0]);
    std::signal(SIGALRM, SIG_DFL);
    ::alarm(kMost_s);
    const rlimit processor_time{kMostProcessorTime_s, kMostProcessorTime_s + 1};
    ::setrlimit(RLIMIT_CPU, &processor_time);
    const std::string text = use();
    for (std::size_t done = 0; done < text.size();) {
      const ssize_t written = ::write(ends[1], text.data() + done, text.size() - done);
      if (written <= 0) break;
      done += std::size_t(written);
    }
    ::_exit(0);
  }
  ::close(ends[1]);
  ChildReport report;
  char block[4096];
  for (ssize_t got = 0; (got = ::read(ends[0], block, sizeof block)) > 0;) report.said.append(block, std::size_t(got));
  ::close(ends[0]);
  int status = 0;
  rusage usage{};
  ::wait4(child, &status, 0, &usage);
  if (WIFSIGNALED(status)) report.death = "signal " + std::to_string(WTERMSIG(status));
  if (WIFEXITED(status) && WEXITSTATUS(status) != 0) report.death = "exit code " + std::to_string(WEXITSTATUS(status));
  report.peak_bytes = std::size_t(usage.ru_maxrss) << 10;
  return report;
}

#ifdef __SANITIZE_ADDRESS__
inline constexpr std::size_t kMostOfChild_bytes =
    2'000'000'000;  // includes memory that the parent freed, which is kept for a while
#else
inline constexpr std::size_t kMostOfChild_bytes = 1'000'000'000;
#endif

/// Expects that the child neither crashed nor reached a limit of time or memory.
inline void expect_survived(const ChildReport& report, const std::string& what) {
  EXPECT_EQ(report.death, "") << what;
  EXPECT_LT(report.peak_bytes, kMostOfChild_bytes) << what;
}

/// Expects one line that begins with the file's path.
inline void expect_names_the_file(const std::string& message, const std::string& path, const std::string& what) {
  EXPECT_EQ(message.substr(0, path.size()), path) << what << ": " << message;
  EXPECT_EQ(message.find('\n'), std::string::npos) << what << ": " << message;
}

}  // namespace tessera::test
