#include "result/folder/run_log.h"

#include <fcntl.h>

#include <cerrno>
#include <filesystem>
#include <system_error>

#include "core/base/error.h"
#include "files/own_file.h"
#include "files/write_all.h"
#include "text/utc_time.h"
#include "text/utf8_text.h"

namespace tessera {

RunLog::RunLog(const std::string& folder) : path_((std::filesystem::path(folder) / "run.log").string()), file_(-1) {
  try {
    file_ = open_own_file(path_, O_WRONLY | O_APPEND);
  } catch (const EnvironmentError& error) {
    problem_ = error.what();
  }
}

void RunLog::info(const std::string& text) { add("info", text); }
void RunLog::warning(const std::string& text) { add("warning", text); }
void RunLog::error(const std::string& text) { add("error", text); }

void RunLog::add(const char* kind, const std::string& text) {
  if (!file_.is_open()) return;
  const std::string line = utc_now() + " " + kind + ": " + printable_utf8(text) + "\n";
  if (!write_all(file_.number(), bytes_of(line)) && problem_.empty())
    problem_ = "cannot write " + path_ + ": " + std::generic_category().message(errno);
}

}  // namespace tessera
