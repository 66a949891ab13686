// Output of tessera. All of it goes through this file: names of files, drawings and results may hold any bytes, and a
// terminal obeys control characters.
#pragma once

#include <string>
#include <vector>

namespace tessera {

/// Prints one line on stdout; format and arguments as printf, without the line end. Characters that do not belong into
/// a line of text (printable_utf8 in text/utf8_text.h), such as tabs and line ends within a name, are printed as '_'.
[[gnu::format(printf, 1, 2)]] void print_line(const char* format, ...);

/// Prints one line on stdout for scripts: the cells with tabs between them. A cell that cannot be printed as it is,
/// e.g. a path of any bytes, is written so that bash reads it back (shell_cell in shell_word.h).
void print_cells(const std::vector<std::string>& cells);

/// Prints lines on stdout, each with its line end. Names in `lines` must hold no line ends: who makes a text of several
/// lines escapes them (TextTable and card_line do).
void print_lines(const std::string& lines);

/// Prints the buffered output of stdout; to be called before a long wait.
void print_now();

/// False once output to stdout was lost, e.g. because its reader has ended: a long list may stop there.
bool printing_works();

/// Prints "tessera: TEXT" on stderr as one line, whatever the text holds.
void print_message(const std::string& text);

/// Prints "tessera: warning: TEXT" on stderr in the same way; prints nothing where `warning` is empty.
void print_warning(const std::string& warning);

/// Opens a file that can be neither read nor written for each of stdin, stdout and stderr that was closed at the start
/// (tessera ... >&-). Otherwise the next opened file would get the number, and output would be printed into it. Must be
/// called before anything is opened.
void occupy_standard_descriptors();

/// Prints the buffered output of stdout. Throws EnvironmentError where any output was lost: the disk is full, or stdout
/// was closed. A reader that ended early (tessera ... | head -1) has what it wanted: that is no error.
void check_printed();

}  // namespace tessera
