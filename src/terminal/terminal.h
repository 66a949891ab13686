// What tessera prints. All of it goes through this file, as names of files, drawings and results may hold anything, and
// a terminal obeys the control characters that it is shown.
#pragma once

#include <string>
#include <vector>

namespace tessera {

/// Prints one line on stdout: the format and arguments of printf, without the line end. What no line of text has
/// (printable_utf8 in text/utf8_text.h) is printed as '_', tabs and line ends within a name among it.
[[gnu::format(printf, 1, 2)]] void print_line(const char* format, ...);

/// Prints one line on stdout for scripts: the cells with tabs between them. What is not to be printed is in a cell that
/// bash reads back (shell_cell in shell_word.h): a path may be any bytes.
void print_cells(const std::vector<std::string>& cells);

/// Prints lines on stdout, each with its line end. The names in `lines` have none of their own: whoever makes a text of
/// several lines escapes them (TextTable and card_line do).
void print_lines(const std::string& lines);

/// Prints what is held back of stdout: before a long wait.
void print_now();

/// False once something printed on stdout was lost, as where the reader has left: a long list may end there.
bool printing_works();

/// Prints "tessera: TEXT" on stderr, in one line whatever the text holds.
void print_message(const std::string& text);

/// Prints "tessera: warning: TEXT" on stderr in the same way; nothing where `warning` is empty.
void print_warning(const std::string& warning);

/// Gives stdin, stdout and stderr descriptors that were closed when the process began (tessera ... >&-) to a file that
/// can be neither read nor written. Else the first file that is opened would get the number, and be printed into. To be
/// called before anything is opened.
void occupy_standard_descriptors();

/// Prints what is still held back of stdout. Throws EnvironmentError where any of what was printed was lost: the disk
/// is full, or stdout was closed. A reader that left early (tessera ... | head -1) has what it wanted: that is no
/// error.
void check_printed();

}  // namespace tessera
