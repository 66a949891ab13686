#include "comm/failure.h"

#include <exception>
#include <filesystem>
#include <new>
#include <system_error>

#include "core/base/error.h"
#include "core/base/process_limits.h"

namespace tessera::comm {
namespace {

/// The text for a system exception that names no file: most often a thread could not be started.
std::string refusal(const std::system_error& error) {
  const std::string reason = error.code().message();
  if (error.code() != std::errc::resource_unavailable_try_again) return "the system refused: " + reason;
  return "the system starts no further thread or process: " + reason + " (ulimit -u, or the container's limit)" +
         process_limits();
}

std::string refusal(const std::filesystem::filesystem_error& error) {
  std::error_code gone;
  const std::filesystem::path current = std::filesystem::current_path(gone);
  if (current.empty()) return "the current folder is not there any more: " + gone.message();
  const std::string files = error.path1().string() + (error.path2().empty() ? "" : ", " + error.path2().string());
  return (files.empty() ? "the system refused" : files) + ": " + error.code().message();
}

}  // namespace

Failure describe_current_exception() {
  try {
    throw;
  } catch (const InputError& error) {
    return {kInputExitCode, error.what()};
  } catch (const EnvironmentError& error) {
    return {kEnvironmentExitCode, error.what()};
  } catch (const std::bad_alloc&) {
    return {kEnvironmentExitCode, "out of memory" + process_limits()};
  } catch (const std::filesystem::filesystem_error& error) {
    return {kEnvironmentExitCode, refusal(error)};
  } catch (const std::system_error& error) {
    return {kEnvironmentExitCode, refusal(error)};
  } catch (const std::exception& error) {
    return {kEnvironmentExitCode, std::string("internal error: ") + error.what()};
  } catch (...) {
    return {kEnvironmentExitCode, "internal error of unknown kind"};
  }
}

void throw_failure(const Failure& failure) {
  if (failure.exit_code == kInputExitCode) throw InputError(failure.text);
  throw EnvironmentError(failure.text);
}

}  // namespace tessera::comm
