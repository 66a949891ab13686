// run.log of a result: what happened when, over all the runs that worked on it. For people; never read by the program.
#pragma once

#include <memory>
#include <string>

namespace spdlog {
class logger;
}

namespace tessera::io {

/// There is a line for each event: time (UTC), "info", "warning" or "error", text. Each is in the file when the call
/// returns. What has control characters is written with "?" for them, so that no event can look like two.
class RunLog {
 public:
  /// Appends to the file in `folder`, which is there. A log that cannot be written is no reason to lose a run:
  /// nothing throws, see problem().
  explicit RunLog(const std::string& folder);

  void info(const std::string& text);
  void warning(const std::string& text);
  void error(const std::string& text);

  /// The first problem that was met, with the file's name; empty where there was none.
  const std::string& problem() const;

 private:
  std::shared_ptr<std::string> problem_;
  std::shared_ptr<spdlog::logger> log_;  // null: could not be opened
};

}  // namespace tessera::io
