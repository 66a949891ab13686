// The effects of signals on a process, seen in child processes that the signals end.
#include "comm/stop_signals.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <string>

namespace tessera::comm {
namespace test_stop_signals {

int cleaned_up = -1;  // the child writes here when it cleans up

struct End {
  int signal = 0;  // 0: the child ended by itself
  int exit_code = 0;
  bool cleaned_up = false;
};

/// Runs `act` in a child process whose stderr is discarded.
template <class Act>
End in_child(Act act) {
  int ends[2];
  EXPECT_EQ(pipe(ends), 0);
  const pid_t child = fork();
  if (child == 0) {
    dup2(open("/dev/null", O_WRONLY), STDERR_FILENO);
    for (const int number : {SIGINT, SIGTERM, SIGHUP, SIGUSR2, SIGXCPU}) signal(number, SIG_DFL);
    cleaned_up = ends[1];
    end_at_once_when_signalled([] { [[maybe_unused]] const ssize_t written = write(cleaned_up, "x", 1); });
    _exit(act());
  }
  close(ends[1]);
  char byte = 0;
  const bool said = read(ends[0], &byte, 1) == 1;
  close(ends[0]);
  int status = 0;
  waitpid(child, &status, 0);
  return {WIFSIGNALED(status) ? WTERMSIG(status) : 0, WIFEXITED(status) ? WEXITSTATUS(status) : 0, said};
}

TEST(StopSignals, EndTheProcessAtOnceAndCleanUp) {
  for (const int number : {SIGINT, SIGTERM, SIGHUP, SIGUSR2, SIGXCPU}) {
    const End end = in_child([&] {
      raise(number);
      return 7;
    });
    EXPECT_EQ(end.signal, number);
    EXPECT_TRUE(end.cleaned_up) << number;
  }
}

TEST(StopSignals, OnesThatAreIgnoredStaySo) {
  const End end = in_child([] {
    signal(SIGHUP, SIG_IGN);
    end_at_once_when_signalled([] {});
    raise(SIGHUP);
    return 7;
  });
  EXPECT_EQ(end.exit_code, 7);
}

TEST(StopSignals, SetAFlagWhereThereIsSomethingToLose) {
  for (const int number : {SIGINT, SIGTERM, SIGHUP, SIGUSR2, SIGXCPU}) {
    const End end = in_child([&] {
      install_stop_handlers();
      if (stop_signalled()) return 1;
      raise(number);
      raise(SIGINT);
      return stop_signalled() ? 7 : 2;
    });
    EXPECT_EQ(end.exit_code, 7) << number;
    EXPECT_FALSE(end.cleaned_up) << number;
  }
}

TEST(StopSignals, TellOfASecondStopButNotOfSeveralSignalsAtOnce) {
  const End end = in_child([] {
    install_stop_handlers();
    raise(SIGTERM);
    raise(SIGINT);
    if (stop_signalled_again()) return 1;
    usleep(1'050'000);
    if (stop_signalled_again()) return 2;
    raise(SIGINT);
    if (seconds_since_stop() < 1.05) return 4;
    return stop_signalled_again() ? 7 : 3;
  });
  EXPECT_EQ(end.exit_code, 7);
}

TEST(StopSignals, AHangupThatNohupIgnoresStaysIgnored) {
  const End end = in_child([] {
    signal(SIGHUP, SIG_IGN);
    install_stop_handlers();
    raise(SIGHUP);
    { const StopDelay delay; }
    end_stop_handlers();
    raise(SIGHUP);
    return stop_signalled() ? 1 : 7;
  });
  EXPECT_EQ(end.exit_code, 7);
}

TEST(StopSignals, EndTheProcessWhenNothingIsLeftToLose) {
  const End before = in_child([] {
    install_stop_handlers();
    raise(SIGINT);
    end_stop_handlers();
    return 7;
  });
  EXPECT_EQ(before.signal, SIGINT) << "one that had come";
  EXPECT_TRUE(before.cleaned_up);
  const End after = in_child([] {
    install_stop_handlers();
    end_stop_handlers();
    if (!stop_signalled()) raise(SIGTERM);
    return 7;
  });
  EXPECT_EQ(after.signal, SIGTERM);
}

TEST(StopSignals, AreDelayedWhileFilesAreWritten) {
  const End end = in_child([] {
    {
      const StopDelay delay;
      raise(SIGTERM);
      if (!stop_signalled()) return 1;
      [[maybe_unused]] const ssize_t written = write(cleaned_up, "x", 1);  // stands for the writing of files
    }
    return 7;
  });
  EXPECT_EQ(end.signal, SIGTERM);
  const End quiet = in_child([] {
    { const StopDelay delay; }
    return stop_signalled() ? 1 : 7;
  });
  EXPECT_EQ(quiet.exit_code, 7);
}

TEST(StopSignals, OfARunAreStillNotedAfterADelay) {
  const End end = in_child([] {
    install_stop_handlers();
    {
      const StopDelay delay;
      raise(SIGTERM);
    }
    return stop_signalled() ? 7 : 1;
  });
  EXPECT_EQ(end.exit_code, 7);
}

}  // namespace test_stop_signals
}  // namespace tessera::comm
