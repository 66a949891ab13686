#include "terminal/terminal.h"

#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

#include <cerrno>
#include <cstdarg>
#include <cstdio>
#include <cstring>

#include "core/base/error.h"
#include "core/base/split_text.h"
#include "terminal/shell_word.h"
#include "text/utf8_text.h"

namespace tessera {
namespace {

/// The text that vsnprintf makes, of any length.
std::string formatted(const char* format, va_list arguments) {
  va_list again;
  va_copy(again, arguments);
  const int length = std::vsnprintf(nullptr, 0, format, arguments);
  std::vector<char> text(std::size_t(length < 0 ? 0 : length) + 1, '\0');
  std::vsnprintf(text.data(), text.size(), format, again);
  va_end(again);
  return text.data();
}

/// errno of the first failure to print; 0 while there was none.
int first_error = 0;

void note_failure(int result) {
  if (result == EOF && first_error == 0) first_error = errno;
}

void put(const std::string& text) { note_failure(std::fputs(text.c_str(), stdout)); }

/// Whether stdout is a pipe or a socket whose reader has ended.
bool reader_has_left() {
  pollfd out{STDOUT_FILENO, POLLOUT, 0};
  return ::poll(&out, 1, 0) == 1 && (out.revents & (POLLERR | POLLHUP)) != 0;
}

}  // namespace

void print_line(const char* format, ...) {
  va_list arguments;
  va_start(arguments, format);
  const std::string line = formatted(format, arguments);
  va_end(arguments);
  put(printable_utf8(line) + "\n");
}

void print_cells(const std::vector<std::string>& cells) {
  std::vector<std::string> escaped;
  for (const std::string& cell : cells) escaped.push_back(shell_cell(cell));
  put(joined(escaped, "\t") + "\n");
}

void print_lines(const std::string& lines) { put(printable_utf8(lines, "\n\t")); }

void print_message(const std::string& text) { std::fprintf(stderr, "tessera: %s\n", printable_utf8(text).c_str()); }

void print_warning(const std::string& warning) {
  if (!warning.empty()) print_message("warning: " + warning);
}

void print_now() { note_failure(std::fflush(stdout)); }

bool printing_works() { return std::ferror(stdout) == 0; }

void occupy_standard_descriptors() {
  for (const int descriptor : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    if (::fcntl(descriptor, F_GETFD) != -1 || errno != EBADF) continue;
    // open() gets the lowest free number: this descriptor. It is opened for the other direction, so every use of it
    // fails.
    static_cast<void>(::open("/dev/null", descriptor == STDIN_FILENO ? O_WRONLY : O_RDONLY));
  }
}

void check_printed() {
  print_now();
  if (printing_works() || reader_has_left()) return;
  const std::string why = first_error == 0       ? ""
                          : first_error == EBADF ? ": it is closed"
                                                 : std::string(": ") + std::strerror(first_error);
  throw EnvironmentError("standard output cannot be written" + why + "; a part of the output is lost");
}

}  // namespace tessera
