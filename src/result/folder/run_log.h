// run.log of a result: what happened when, over all the runs that worked on it. For people; never read by the program.
#pragma once

#include <string>

#include "files/file_descriptor.h"

namespace tessera {

/// There is a line for each event: time (UTC), "info", "warning" or "error", text. Each is in the file when the call
/// returns. What has control characters is written with "_" for them, so that no event can look like two.
class RunLog {
 public:
  /// Appends to the file in `folder`, which is there (own_file.h says what else may not be there in its place). A log
  /// that cannot be written is no reason to lose a run: nothing throws, see problem().
  explicit RunLog(const std::string& folder);

  void info(const std::string& text);
  void warning(const std::string& text);
  void error(const std::string& text);

  /// The first problem that was met, with the file's name; empty where there was none.
  const std::string& problem() const { return problem_; }

 private:
  void add(const char* kind, const std::string& text);

  std::string path_;
  FileDescriptor file_;
  std::string problem_;
};

}  // namespace tessera
