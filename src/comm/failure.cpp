#include "comm/failure.h"

#include <exception>
#include <new>

#include "core/base/error.h"

namespace tessera::comm {

Failure describe_current_exception() {
  try {
    throw;
  } catch (const InputError& error) {
    return {kInputExitCode, error.what()};
  } catch (const EnvironmentError& error) {
    return {kEnvironmentExitCode, error.what()};
  } catch (const std::bad_alloc&) {
    return {kEnvironmentExitCode, "out of memory"};
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
