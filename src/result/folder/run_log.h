// Writes the run.log of a result: what happened when, in all runs that worked on it. It is for people; the program never
// reads it.
#pragma once

#include <string>

#include "files/file_descriptor.h"

namespace tessera {

/// Writes a line for each event: time (UTC), "info", "warning" or "error", text. Each line is in the file when the call
/// returns. Control characters become "_", so that no event can look like two.
class RunLog {
 public:
  /// Appends to the file in `folder`, which must exist (own_file.h says what may not have the file's name). Nothing throws
  /// where the log cannot be written, because that is no reason to lose a run; see problem().
  explicit RunLog(const std::string& folder);

  void info(const std::string& text);
  void warning(const std::string& text);
  void error(const std::string& text);

  /// The first problem, with the file's name; empty where there was none.
  const std::string& problem() const { return problem_; }

 private:
  void add(const char* kind, const std::string& text);

  std::string path_;
  FileDescriptor file_;
  std::string problem_;
};

}  // namespace tessera
