#include "io/result/run_log.h"

#include <spdlog/sinks/basic_file_sink.h>
#include <spdlog/spdlog.h>

#include <filesystem>

#include "io/utf8_text.h"

namespace tessera::io {
namespace {

namespace fs = std::filesystem;

/// Opening anything else to append to it could wait for ever (a FIFO).
bool may_be_log(const std::string& path) {
  std::error_code ignored;
  const fs::file_status status = fs::status(path, ignored);
  return !fs::exists(status) || fs::is_regular_file(status);
}

}  // namespace

RunLog::RunLog(const std::string& folder) : problem_(std::make_shared<std::string>()) {
  const std::string path = (fs::path(folder) / "run.log").string();
  const auto remember = [problem = problem_, path](const std::string& reason) {
    if (problem->empty()) *problem = path + ": " + reason;
  };
  if (!may_be_log(path)) {
    remember("not a regular file");
    return;
  }
  try {
    log_ = std::make_shared<spdlog::logger>("run", std::make_shared<spdlog::sinks::basic_file_sink_st>(path));
  } catch (const spdlog::spdlog_ex& error) {
    remember(error.what());
    return;
  }
  log_->set_pattern("%Y-%m-%dT%H:%M:%SZ %l: %v", spdlog::pattern_time_type::utc);
  log_->flush_on(spdlog::level::info);
  log_->set_error_handler(remember);
}

void RunLog::info(const std::string& text) {
  if (log_) log_->info("{}", printable_utf8(text));
}

void RunLog::warning(const std::string& text) {
  if (log_) log_->warn("{}", printable_utf8(text));
}

void RunLog::error(const std::string& text) {
  if (log_) log_->error("{}", printable_utf8(text));
}

const std::string& RunLog::problem() const { return *problem_; }

}  // namespace tessera::io
