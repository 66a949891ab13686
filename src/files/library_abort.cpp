#include "files/library_abort.h"

#include <signal.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <string>

#include "core/base/process_limits.h"
#include "files/leftover_file.h"

namespace tessera {
namespace {

/// Prepared in advance: a signal handler may not allocate memory.
std::array<char, 256> words;
std::size_t word_bytes = 0;  // 0: nothing is printed
bool lives = false;

void tell() { [[maybe_unused]] const ssize_t written = write(STDERR_FILENO, words.data(), word_bytes); }

void on_abort(int) {
  remove_leftover_files();
  tell();
  if (word_bytes > 0) _exit(EXIT_FAILURE);
  // The handler is reset (SA_RESETHAND); abort() goes on and ends the process.
}

}  // namespace

LibraryAbortHandler::LibraryAbortHandler() {
  [[maybe_unused]] static const int registered = std::atexit(tell);
  const std::string limits = process_limits();
  const std::string text = "tessera: a library, such as an OpenCL driver, has ended the program" + limits + "\n";
  word_bytes = limits.empty() ? 0 : std::min(text.size(), words.size());
  std::copy_n(text.begin(), word_bytes, words.begin());
  lives = true;
  set_abort_handler_again();
}

LibraryAbortHandler::~LibraryAbortHandler() {
  word_bytes = 0;
  lives = false;
  signal(SIGABRT, SIG_DFL);
}

void set_abort_handler_again() {
  if (!lives) return;
  struct sigaction action = {};
  action.sa_handler = on_abort;
  action.sa_flags = SA_RESETHAND;
  sigaction(SIGABRT, &action, nullptr);
}

}  // namespace tessera
